// Fit, sizes, rounding and gap of the law that is written.
#include "diagnosis/results/written_law.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <utility>

#include "diagnosis/results/rounding.h"
#include "diagnosis/results/simplest_law.h"
#include "diagnosis/results/sizes.h"

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
double roundTo(const io::ComponentDescription& exact, const std::vector<log::Record>& records, Diagnosis& diagnosis) {
  const double square = squareInSample(exact, records);
  for (diagnosis.finer = 0; diagnosis.finer < kMostFiner; ++diagnosis.finer) {
    try {
      diagnosis.augmented = rounded(exact, diagnosis.written, diagnosis.finer);
    } catch (const std::runtime_error&) {
      continue;  // so roughly there is no such component
    }
    const double ratio = squareInSample(diagnosis.augmented, records) / square;
    if (ratio <= std::pow(1.0 + kShows, 2)) {
      return ratio;
    }
  }
  diagnosis.augmented = exact;
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

io::ComponentDescription componentOf(const PreparedCase& prepared, const FittedLaw& fitted) {
  io::ComponentDescription result = prepared.model.apply(fitted.fit.parameters.model);
  for (const Entries& entries : fitted.law.at(fitted.fit.parameters.scales)) {
    result.add.insert(result.add.end(), entries.begin(), entries.end());
  }
  result.valid_displacement = prepared.component.valid_displacement;
  result.units = prepared.component.units;
  return result;
}

}  // namespace

std::vector<gap::PartError> addWrittenLaw(const PreparedCase& prepared, const std::vector<fit::Candidate>& candidates,
                                          const FittedHypothesis& judged, double before,
                                          const DiagnosisOptions& options, Diagnosis& diagnosis) {
  const HeldOut held_out{prepared.held_out, prepared.zeros.held_out};
  const SimplestLaw chosen = simplestLaw(prepared.fitter, candidates, judged, held_out, before, options.threads);
  const FittedLaw& simple = chosen.fitted;
  const FittedLaw full = fullLaw(judged, candidates);
  std::deque<LawFitter> fitters;
  std::vector<SizedLaw> laws;
  const auto addLaw = [&](const FittedLaw& law) {
    laws.push_back({fitters.emplace_back(prepared.fitter, law.law, options.threads), law});
  };
  addLaw(simple);
  std::for_each(chosen.others.begin(), chosen.others.end(), addLaw);
  addSizes(laws, chosen.form_error, candidates, options, diagnosis);
  diagnosis.augmented_full = componentOf(prepared, full);
  const io::ComponentDescription exact = componentOf(prepared, simple);
  const double ratio = roundTo(exact, prepared.training, diagnosis);
  if (!prepared.held_out.empty()) {
    diagnosis.gap_of_full_law = gap::gapOfParts(unseenErrors(prepared.model, full, held_out));
    return unseenErrors(prepared.model, simple, held_out, byRounding(exact, diagnosis.augmented, prepared.held_out));
  }
  diagnosis.gap_of_full_law = gap::gapOfParts(judged.fit.blocks);
  std::vector<gap::PartError> errors = simple.fit.blocks;
  for (gap::PartError& error : errors) {
    error.error *= ratio;
  }
  return errors;
}

}  // namespace rubber_suspension::diagnosis
