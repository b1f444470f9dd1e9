// Candidate effect: amplitude dependence that itself depends on the rate.
#include <array>

#include "diagnosis/candidate/registry.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr std::array<double, 3> kBands = {0.03, 0.15,
                                          0.7};  // break frequencies over the highest frequency of the motion

// Flow that large forces accelerate, and flow that begins at a limit of the force.
void addFlow(const fit::Excitation& excitation, std::vector<fit::BasisTerm>& terms) {
  for (const double band : kBands) {
    for (const double share : {0.03, 0.1, 0.3}) {
      const double yield = share * excitation.largest_displacement;
      const double frequency = band * excitation.highest_frequency;
      terms.push_back(fit::additiveTerm("nonlinear_maxwell", "stiffness", 0.2 * excitation.stiffness,
                                        {{"break_frequency", {frequency}}, {"displacement", {yield}}}));
      terms.push_back(fit::additiveTerm("sliding_maxwell", "stiffness", 0.2 * excitation.stiffness,
                                        {{"break_frequency", {frequency}}, {"yield_displacement", {yield}}}));
    }
  }
}

// A structure that motion breaks and rest builds up again.
void addThixotropy(const fit::Excitation& excitation, std::vector<fit::BasisTerm>& terms) {
  for (const double band : kBands) {
    for (const double build_up : {0.5, 5.0}) {  // cycles of the highest frequency
      for (const double travel : {0.3, 2.0}) {  // largest displacements
        terms.push_back(fit::additiveTerm("thixotropic_maxwell", "stiffness", 0.2 * excitation.stiffness,
                                          {{"break_frequency", {band * excitation.highest_frequency}},
                                           {"build_up_time", {build_up / excitation.highest_frequency}},
                                           {"travel", {travel * excitation.largest_displacement}}}));
      }
    }
  }
}

// It can look like friction and like relaxation, which are the simpler explanations: named only where they fail.
fit::Candidate rateAmplitudeCoupling(const fit::Excitation& excitation) {
  fit::Candidate candidate{"rate_amplitude_coupling",
                           "flow that large forces or fast motion accelerate: stiffness falls with amplitude, and more "
                           "so at higher frequency",
                           false,
                           {},
                           false,
                           true};
  addFlow(excitation, candidate.terms);
  addThixotropy(excitation, candidate.terms);
  return candidate;
}

const CandidateEntry kEntry(160, rateAmplitudeCoupling);

}  // namespace
}  // namespace rubber_suspension::diagnosis
