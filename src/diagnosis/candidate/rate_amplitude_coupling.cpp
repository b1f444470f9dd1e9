// Candidate effect: amplitude dependence that itself depends on the rate.
#include "diagnosis/candidate/registry.h"

namespace rubber_suspension::diagnosis {
namespace {

// It can look like friction and like relaxation, which are the simpler explanations: named only where they fail.
fit::Candidate rateAmplitudeCoupling(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "rate_amplitude_coupling",
      "flow that large forces accelerate: stiffness falls with amplitude, and more so at higher frequency",
      false,
      {},
      false,
      true};
  for (const double band : {0.03, 0.15, 0.7}) {
    for (const double share : {0.03, 0.1, 0.3}) {
      candidate.terms.push_back(fit::additiveTerm("nonlinear_maxwell", "stiffness", 0.2 * excitation.stiffness,
                                                  {{"break_frequency", {band * excitation.highest_frequency}},
                                                   {"displacement", {share * excitation.largest_displacement}}}));
    }
  }
  return candidate;
}

const CandidateEntry kEntry(160, rateAmplitudeCoupling);

}  // namespace
}  // namespace rubber_suspension::diagnosis
