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

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr int kMostFiner = 8;
constexpr double kShows = 0.01;  // of a gap: rounding that changes it by less does not show

gap::Forces smoothedForces(const io::ComponentDescription& component, const std::vector<log::Record>& records) {
  return gap::simulateEach(component.allElements(), records,
                           [](const log::Record& record) { return record.displacement; });
}

double squaredGap(const std::vector<log::Record>& records, const gap::Forces& forces) {
  return std::pow(gap::gapOfParts(gap::partErrors(records, forces)), 2);
}

// What rounding changes of the logs of the fit.
struct Rounding {
  double ratio = 1.0;   // of the squared gap to that before
  gap::Forces exact;    // forces before [N]
  gap::Forces rounded;  // and after; both none where nothing is rounded
};

// The exact component rounded as far as the gap allows.
Rounding roundTo(const io::ComponentDescription& exact, const std::vector<log::Record>& records, Diagnosis& diagnosis) {
  Rounding result{1.0, gap::simulate(exact.allElements(), records), {}};
  const double square = squaredGap(records, result.exact);
  for (diagnosis.finer = 0; diagnosis.finer < kMostFiner; ++diagnosis.finer) {
    try {
      diagnosis.augmented = rounded(exact, diagnosis.written, diagnosis.finer);
    } catch (const std::runtime_error&) {
      continue;  // so roughly there is no such component
    }
    result.rounded = gap::simulate(diagnosis.augmented.allElements(), records);
    result.ratio = squaredGap(records, result.rounded) / square;
    if (result.ratio <= std::pow(1.0 + kShows, 2)) {
      return result;
    }
  }
  diagnosis.augmented = exact;
  return {};
}

// Adds to forces what rounding changes: the force of a mass itself samples to come tell better than its entry.
void addRounding(const gap::Forces& exact, const gap::Forces& rounded, gap::Forces& forces) {
  for (std::size_t r = 0; r < rounded.size(); ++r) {
    forces[r] += rounded[r] - exact[r];
  }
}

// Forces of the law that is written on the logs of the fit, then on those held out.
gap::Forces writtenForces(const hypotheses::PreparedCase& prepared, const FittedLaw& law,
                          const io::ComponentDescription& exact, const io::ComponentDescription& rounded,
                          const Rounding& rounding) {
  gap::Forces forces = *LawForces(prepared.fitter.sharedRecords(), prepared.model, law.law).at(law.fit.parameters);
  addRounding(rounding.exact, rounding.rounded, forces);
  gap::Forces unseen = predict(prepared.model, law, prepared.held_out);
  addRounding(smoothedForces(exact, prepared.held_out), smoothedForces(rounded, prepared.held_out), unseen);
  forces.insert(forces.end(), unseen.begin(), unseen.end());
  return forces;
}

io::ComponentDescription componentOf(const hypotheses::PreparedCase& prepared, const FittedLaw& fitted) {
  io::ComponentDescription result = prepared.model.apply(fitted.fit.parameters.model);
  for (const Entries& entries : fitted.law.at(fitted.fit.parameters.scales)) {
    result.add.insert(result.add.end(), entries.begin(), entries.end());
  }
  result.valid_displacement = prepared.component.valid_displacement;
  result.excluded_effects = prepared.component.excluded_effects;
  result.units = prepared.component.units;
  return result;
}

// Of the entries of a law, one after the other, the effects.
std::vector<std::string> ownersOf(const FittedLaw& fitted, const std::vector<fit::Candidate>& candidates) {
  std::vector<std::string> owners;
  const std::vector<Entries> of_members = fitted.law.at(fitted.fit.parameters.scales);
  for (std::size_t m = 0; m < of_members.size(); ++m) {
    const auto candidate = static_cast<std::size_t>(fitted.law.members[m].member);
    owners.insert(owners.end(), of_members[m].size(), candidates[candidate].effect);
  }
  return owners;
}

}  // namespace

WrittenLaw addWrittenLaw(const hypotheses::PreparedCase& prepared, const std::vector<fit::Candidate>& candidates,
                         const hypotheses::FittedHypothesis& judged, double before, const DiagnosisOptions& options,
                         Diagnosis& diagnosis) {
  const HeldOut held_out{prepared.held_out, prepared.zeros.held_out};
  const SimplestLaw chosen = simplestLaw(prepared.fitter, candidates, judged, held_out, before, options.threads);
  const FittedLaw& simple = chosen.fitted;
  const FittedLaw full = fullLaw(judged);
  std::deque<LawFitter> fitters;
  std::vector<SizedLaw> laws;
  const auto addLaw = [&](const FittedLaw& law) {
    laws.push_back({fitters.emplace_back(prepared.fitter, law.law, options.threads), law});
  };
  addLaw(simple);
  std::for_each(chosen.others.begin(), chosen.others.end(), addLaw);
  addSizes(laws, chosen.form_error, candidates, options, diagnosis);
  diagnosis.added_for = ownersOf(simple, candidates);
  diagnosis.augmented_full = componentOf(prepared, full);
  const io::ComponentDescription exact = componentOf(prepared, simple);
  const Rounding rounding = roundTo(exact, prepared.training, diagnosis);
  WrittenLaw written{simple.fit.blocks, writtenForces(prepared, simple, exact, diagnosis.augmented, rounding)};
  if (!prepared.held_out.empty()) {
    const gap::Forces unseen(written.forces.begin() + static_cast<std::ptrdiff_t>(prepared.training.size()),
                             written.forces.end());
    written.errors = unseenErrors(prepared.model, simple, held_out, unseen);
    diagnosis.gap_of_full_law =
        gap::gapOfParts(unseenErrors(prepared.model, full, held_out, predict(prepared.model, full, prepared.held_out)));
    return written;
  }
  diagnosis.gap_of_full_law = gap::gapOfParts(judged.fit.blocks);
  for (gap::PartError& error : written.errors) {
    error.error *= rounding.ratio;
  }
  return written;
}

}  // namespace rubber_suspension::diagnosis::results
