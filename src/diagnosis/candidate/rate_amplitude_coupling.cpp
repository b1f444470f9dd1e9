// Candidate effect: amplitude dependence that itself depends on the rate.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

// It can look like friction and like relaxation, which are the simpler explanations: named only where they fail.
fit::Candidate rateAmplitudeCouplingCandidate(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "rate_amplitude_coupling",
      "flow that large forces accelerate: stiffness falls with amplitude, and more so at higher frequency",
      false,
      {},
      false,
      true};
  for (const double band : {0.03, 0.15, 0.7}) {
    for (const double share : {0.03, 0.1, 0.3}) {
      candidate.atoms.push_back(fit::additiveAtom("nonlinear_maxwell", "stiffness", 0.2 * excitation.stiffness,
                                                  {{"break_frequency", {band * excitation.highest_frequency}},
                                                   {"displacement", {share * excitation.largest_displacement}}}));
    }
  }
  return candidate;
}

}  // namespace rubber_suspension::diagnosis
