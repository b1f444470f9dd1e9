// Hypotheses and the unit effects of their basis terms.
#include "fit/hypothesis.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "element/each.h"
#include "fit/parallel.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::fit {
namespace {

// Returns the share by which a softening term at scale 1 reduces the force, from the factors of its law.
gap::Forces softenedShare(const BasisTerm& term, const std::vector<gap::PreparedRecord>& records) {
  const auto law = std::get<std::shared_ptr<const element::ForceEffect>>(element::makeElement(term.at(term.typical)));
  std::vector<double> memory(law->memorySize());
  gap::Forces result;
  for (const log::Record& record : records) {
    const Eigen::VectorXd& z = record.displacement;
    const bool led_in = !record.lead_in.displacement.empty();
    double last = led_in ? record.lead_in.displacement[0] : z[0];
    Eigen::VectorXd factor(z.size());
    if (result.empty()) {
      law->initialise(last, memory.data());
      factor[0] = law->constantFactor().value_or(1.0);
    } else if (!record.lead_in.continues) {
      factor[0] = law->relax(last, memory.data());
    }
    const auto step = [&](double dt, double displacement) {
      const double before = std::exchange(last, displacement);
      return law->step({dt, displacement, displacement - before}, {}, memory.data());
    };
    for (const double displacement : record.lead_in.displacement) {
      step(record.lead_in.dt, displacement);
    }
    for (Eigen::Index i = led_in ? 0 : 1; i < z.size(); ++i) {
      factor[i] = step(record.dt, z[i]);
    }
    result.emplace_back((1.0 - factor.array()) / term.typical);
  }
  return result;
}

bool isAmong(const std::vector<int>& list, int one) { return std::find(list.begin(), list.end(), one) != list.end(); }

// Adds the terms of a candidate that the hypothesis lacks, along the curve if `curved` contains the candidate.
void addTerms(const std::vector<Candidate>& candidates, int candidate, const std::vector<int>& curved,
              Hypothesis& hypothesis) {
  const Candidate& of = candidates[static_cast<std::size_t>(candidate)];
  const bool along = isAmong(curved, candidate) && !of.curved.empty();
  if (along && !isAmong(hypothesis.curved, candidate)) {
    hypothesis.curved.push_back(candidate);
  }
  const std::vector<BasisTerm>& terms = along ? of.curved : of.terms;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const TermPlace place{candidate, (along ? of.terms.size() : 0) + t};
    if (std::find(hypothesis.places.begin(), hypothesis.places.end(), place) == hypothesis.places.end()) {
      hypothesis.terms.push_back(terms[t]);
      hypothesis.places.push_back(place);
    }
  }
}

// Returns the contained law that a candidate extends, rather one that no other extends, in the order of `preferred`.
std::optional<int> heldBy(const std::vector<Candidate>& candidates, int larger, const std::vector<int>& preferred,
                          const std::vector<int>& by_others) {
  const std::vector<int> contained = containedBy(candidates, candidates[static_cast<std::size_t>(larger)]);
  const auto order = [&](int one) { return std::find(preferred.begin(), preferred.end(), one); };
  const auto best = std::min_element(contained.begin(), contained.end(), [&](int a, int b) {
    return std::pair(isAmong(by_others, a), order(a)) < std::pair(isAmong(by_others, b), order(b));
  });
  return best == contained.end() ? std::nullopt : std::optional(*best);
}

gap::Forces unitEffect(const BasisTerm& term, const std::vector<gap::PreparedRecord>& records) {
  return term.exact ? element::each(records, term.exact) : effectOfEntry(term, records);
}

}  // namespace

gap::Forces effectOfEntry(const BasisTerm& term, const std::vector<gap::PreparedRecord>& records) {
  if (term.softening) {
    return softenedShare(term, records);
  }
  gap::Forces result = gap::simulate({term.at(term.typical)}, records);
  for (Eigen::VectorXd& force : result) {
    force /= term.typical;
  }
  return result;
}

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

Hypothesis makeHypothesis(const std::vector<Candidate>& candidates, const std::vector<int>& members,
                          const std::vector<int>& preferred, const std::vector<int>& curved) {
  Hypothesis hypothesis;
  hypothesis.members = members;
  for (const int member : members) {
    const Candidate& candidate = candidates[static_cast<std::size_t>(member)];
    const std::size_t before = hypothesis.terms.size();
    addTerms(candidates, member, curved, hypothesis);
    if (const auto held = heldBy(candidates, member, preferred, hypothesis.held)) {
      addTerms(candidates, *held, curved, hypothesis);
      hypothesis.held.push_back(*held);
    }
    hypothesis.counts.push_back(hypothesis.terms.size() - before);
    hypothesis.free_in_log = hypothesis.free_in_log | candidate.free_in_log;
    hypothesis.like_parameters = hypothesis.like_parameters || candidate.like_parameters;
  }
  return hypothesis;
}

bool contains(const Candidate& larger, const Candidate& smaller) {
  return std::find(larger.contains.begin(), larger.contains.end(), smaller.effect) != larger.contains.end();
}

std::vector<int> containedBy(const std::vector<Candidate>& candidates, const Candidate& larger) {
  std::vector<int> contained;
  for (std::size_t other = 0; other < candidates.size(); ++other) {
    if (contains(larger, candidates[other])) {
      contained.push_back(static_cast<int>(other));
    }
  }
  return contained;
}

bool holds(const std::vector<Candidate>& candidates, const std::vector<int>& larger, const std::vector<int>& smaller) {
  std::vector<int> order = larger;
  std::sort(order.begin(), order.end());
  const auto does = [&](int one, int member) {
    return member == one ||
           contains(candidates[static_cast<std::size_t>(member)], candidates[static_cast<std::size_t>(one)]);
  };
  bool found = false;
  do {  // a hypothesis has at most three candidates
    found =
        found || (smaller.size() <= order.size() && std::equal(smaller.begin(), smaller.end(), order.begin(), does));
  } while (std::next_permutation(order.begin(), order.end()));
  return found;
}

std::size_t numbersBeyond(const std::vector<Candidate>& candidates, const Hypothesis& hypothesis,
                          const Eigen::VectorXd& scales) {
  std::size_t numbers = hypothesis.curved.size();
  std::size_t first = 0;
  for (std::size_t m = 0; m < hypothesis.members.size(); ++m) {
    const Candidate& candidate = candidates[static_cast<std::size_t>(hypothesis.members[m])];
    std::size_t own = candidate.terms_at ? 1 : 0;
    std::size_t contained = 0;
    std::size_t alone = 0;  // numbers of the contained law that was fitted alone
    for (std::size_t t = first; t < first + hypothesis.counts[m]; ++t) {
      const int of = hypothesis.places[t].candidate;
      const bool is_own = of == hypothesis.members[m];
      (is_own ? own : contained) += scales[static_cast<Eigen::Index>(t)] != 0.0;
      alone = is_own ? alone : candidates[static_cast<std::size_t>(of)].numbers_alone;
    }
    if (candidate.contains.empty()) {
      numbers += candidate.terms_of_one > 0 ? std::max(own, candidate.terms_of_one) - candidate.terms_of_one : 0;
    } else {
      const std::size_t replaced = std::max(contained, alone);
      numbers += std::max(own + contained, replaced + 1) - replaced;
    }
    first += hypothesis.counts[m];
  }
  return numbers;
}

void findUnitEffects(std::vector<Candidate>& candidates, const std::vector<gap::PreparedRecord>& records, int threads) {
  std::vector<BasisTerm*> known;
  for (Candidate& candidate : candidates) {
    for (BasisTerm& term : candidate.terms) {
      if (term.hasUnitEffect()) {
        known.push_back(&term);
      }
    }
  }
  parallelFor(known.size(), threads,
              [&](std::size_t i) { known[i]->unit_effect = columnOf(unitEffect(*known[i], records)); });
}

Hypothesis aboutOtherRecords(const Hypothesis& hypothesis, const std::vector<gap::PreparedRecord>& records) {
  Hypothesis other = hypothesis;
  for (BasisTerm& term : other.terms) {
    term.unit_effect = term.exact ? columnOf(element::each(records, term.exact)) : nullptr;
  }
  return other;
}

}  // namespace rubber_suspension::fit
