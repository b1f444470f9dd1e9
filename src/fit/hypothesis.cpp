// Hypotheses and the unit effects of their basis terms.
#include "fit/hypothesis.h"

#include <algorithm>
#include <utility>

#include "element/each.h"
#include "fit/parallel.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::fit {
namespace {

// Share of the component's force that a softening term takes at scale 1, by the factors of its law.
gap::Forces softenedShare(const BasisTerm& term, const std::vector<log::Record>& records) {
  const auto law = std::get<std::shared_ptr<const element::ForceEffect>>(element::makeElement(term.at(term.typical)));
  std::vector<double> memory(law->memorySize());
  gap::Forces result;
  for (const log::Record& record : records) {
    const Eigen::VectorXd& z = record.displacement;
    const bool led_in = record.lead_in.size() > 0;
    double last = led_in ? record.lead_in[0] : z[0];
    Eigen::VectorXd factor(z.size());
    if (result.empty()) {
      law->initialise(last, memory.data());
      factor[0] = law->constantFactor().value_or(1.0);
    } else if (!record.continues) {
      factor[0] = law->relax(last, memory.data());
    }
    const auto step = [&](double dt, double displacement) {
      const double before = std::exchange(last, displacement);
      return law->step({dt, displacement, displacement - before}, {}, memory.data());
    };
    for (const double displacement : record.lead_in) {
      step(record.lead_in_dt, displacement);
    }
    for (Eigen::Index i = led_in ? 0 : 1; i < z.size(); ++i) {
      factor[i] = step(record.dt, z[i]);
    }
    result.emplace_back((1.0 - factor.array()) / term.typical);
  }
  return result;
}

gap::Forces addedForce(const BasisTerm& term, const std::vector<log::Record>& records) {
  gap::Forces result = gap::simulate({term.at(term.typical)}, records);
  for (Eigen::VectorXd& force : result) {
    force /= term.typical;
  }
  return result;
}

gap::Forces unitEffect(const BasisTerm& term, const std::vector<log::Record>& records) {
  return term.softening ? softenedShare(term, records)
         : term.exact   ? element::each(records, term.exact)
                        : addedForce(term, records);
}

}  // namespace

BasisTerm additiveTerm(const std::string& type, const std::string& scaled, double typical,
                       const element::ParameterValues& others) {
  BasisTerm term;
  term.typical = typical;
  term.at = [=](double scale) {
    element::ElementDescription description{type, others};
    description.values[scaled] = {scale};
    return description;
  };
  return term;
}

bool Hypothesis::isAdditive() const {
  return std::all_of(terms.begin(), terms.end(), [](const BasisTerm& term) { return term.additive; });
}

Hypothesis makeHypothesis(const std::vector<Candidate>& candidates, const std::vector<int>& members) {
  Hypothesis hypothesis;
  hypothesis.members = members;
  for (const int member : members) {
    const Candidate& candidate = candidates[static_cast<std::size_t>(member)];
    hypothesis.terms.insert(hypothesis.terms.end(), candidate.terms.begin(), candidate.terms.end());
    hypothesis.free_in_log = hypothesis.free_in_log | candidate.free_in_log;
    hypothesis.like_parameters = hypothesis.like_parameters || candidate.like_parameters;
  }
  return hypothesis;
}

void findUnitEffects(std::vector<Candidate>& candidates, const std::vector<log::Record>& records, int threads) {
  std::vector<BasisTerm*> known;
  for (Candidate& candidate : candidates) {
    for (BasisTerm& term : candidate.terms) {
      if (term.additive || term.softening) {
        known.push_back(&term);
      }
    }
  }
  parallelFor(known.size(), threads,
              [&](std::size_t i) { known[i]->unit_effect = columnOf(unitEffect(*known[i], records)); });
}

Hypothesis aboutOtherRecords(const Hypothesis& hypothesis, const std::vector<log::Record>& records) {
  Hypothesis other = hypothesis;
  for (BasisTerm& term : other.terms) {
    term.unit_effect = term.exact ? columnOf(element::each(records, term.exact)) : nullptr;
  }
  return other;
}

}  // namespace rubber_suspension::fit
