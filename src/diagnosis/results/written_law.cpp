// Fit, sizes, rounding and gap of the law that is written.
#include "diagnosis/results/written_law.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "diagnosis/judge/score.h"
#include "diagnosis/results/rounding.h"
#include "diagnosis/results/simplest_law.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr int kMostFiner = 8;
constexpr double kShows = 0.01;  // of a gap: rounding that changes it by less does not show

gap::Forces smoothedForces(const io::ComponentDescription& component, const std::vector<log::Record>& records) {
  return gap::simulateEach(component.allElements(), records,
                           [](const log::Record& record) { return record.displacement; });
}

double squareInSample(const io::ComponentDescription& component, const std::vector<log::Record>& records) {
  return std::pow(gap::gapOfParts(gap::partErrors(records, gap::simulate(component.allElements(), records))), 2);
}

// The exact component rounded as far as the gap allows, and by how much that changes the squared gap in sample.
double roundTo(const io::ComponentDescription& exact, const std::vector<log::Record>& records, WrittenLaw& law) {
  const double square = squareInSample(exact, records);
  for (law.finer = 0; law.finer < kMostFiner; ++law.finer) {
    try {
      law.component = rounded(exact, law.sizes.written, law.finer);
    } catch (const std::runtime_error&) {
      continue;  // so roughly there is no such component
    }
    const double ratio = squareInSample(law.component, records) / square;
    if (ratio <= std::pow(1.0 + kShows, 2)) {
      return ratio;
    }
  }
  law.component = exact;
  return 1.0;
}

// The force that rounding adds on the logs held out: that of a mass itself samples to come tell better.
gap::Forces byRounding(const io::ComponentDescription& exact, const io::ComponentDescription& component,
                       const std::vector<log::Record>& records) {
  const gap::Forces before = smoothedForces(exact, records);
  gap::Forces change = smoothedForces(component, records);
  for (std::size_t r = 0; r < change.size(); ++r) {
    change[r] -= before[r];
  }
  return change;
}

// How probable a law is by what it leaves more than the best of all, as the judgement sees it.
double weightOf(double gap, const SimplestLaw& simple) {
  const JudgeNumbers& numbers = fittedNumbers();
  double least = simple.gap;
  for (const auto& other : simple.others) {
    least = std::min(least, other.first);
  }
  const double expected = std::inner_product(simple.form_error.begin(), simple.form_error.end(),
                                             simple.form_error.begin(), numbers.accepted * numbers.accepted);
  return std::exp(-0.5 * numbers.sharpness * lossOf(gap * gap - least * least, expected, numbers));
}

io::ComponentDescription componentOf(const PreparedCase& prepared, const fit::ParameterVector& parameters,
                                     const std::vector<Entries>& added) {
  io::ComponentDescription result = prepared.model.apply(parameters.model);
  for (const Entries& entries : added) {
    result.add.insert(result.add.end(), entries.begin(), entries.end());
  }
  result.valid_displacement = prepared.component.valid_displacement;
  result.units = prepared.component.units;
  return result;
}

}  // namespace

WrittenLaw writtenLaw(const PreparedCase& prepared, const std::vector<fit::Candidate>& candidates,
                      const FittedHypothesis& judged, double before, const DiagnosisOptions& options) {
  const HeldOut held_out{prepared.held_out, prepared.zeros.held_out};
  const SimplestLaw simple = simplestLaw(prepared.fitter, candidates, judged, held_out, before, options.threads);
  const FittedLaw full = fullLaw(judged, candidates);
  std::deque<LawFitter> fitters;
  std::vector<SizedLaw> laws;
  const auto addLaw = [&](double gap, const FittedLaw& one) {
    laws.push_back({fitters.emplace_back(prepared.fitter, one.law, options.threads), one, weightOf(gap, simple)});
  };
  addLaw(simple.gap, simple.fitted);
  for (const auto& [gap, other] : simple.others) {
    addLaw(gap, other);
  }
  WrittenLaw law;
  law.sizes = sizesOf(laws, simple.form_error, effectsOf(simple.fitted.law, candidates), options);
  law.full = componentOf(prepared, full.fit.parameters, full.law.at(full.fit.parameters.scales));
  const auto exact =
      componentOf(prepared, simple.fitted.fit.parameters, simple.fitted.law.at(simple.fitted.fit.parameters.scales));
  const double ratio = roundTo(exact, prepared.training, law);
  if (prepared.held_out.empty()) {
    law.errors = simple.fitted.fit.blocks;
    for (gap::PartError& error : law.errors) {
      error.error *= ratio;
    }
    law.full_gap = gap::gapOfParts(judged.fit.blocks);
  } else {
    law.errors =
        unseenErrors(prepared.model, simple.fitted, held_out, byRounding(exact, law.component, prepared.held_out));
    law.full_gap = gap::gapOfParts(unseenErrors(prepared.model, full, held_out));
  }
  return law;
}

}  // namespace rubber_suspension::diagnosis
