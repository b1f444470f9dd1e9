// Candidate effect: a dependence on amplitude that itself depends on the rate.
#include <array>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

constexpr std::array<double, 3> kBands = {0.03, 0.15, 0.7};  // break frequencies / highest frequency of the motion

// Adds Maxwell elements whose flow is accelerated by large forces, and others that flow beyond a limit of the force.
void addFlow(const fit::Excitation& excitation, std::vector<fit::BasisTerm>& terms) {
  const auto add = [&](const char* law, const char* limit, double band, double share,
                       element::ParameterValues shape = {}) {
    shape["break_frequency"] = {band * excitation.highest_frequency};
    shape[limit] = {share * excitation.largest_displacement};
    terms.push_back(fit::additiveTerm(law, "stiffness", 0.2 * excitation.stiffness, shape));
  };
  for (const double band : kBands) {
    for (const double share : {0.03, 0.1, 0.3}) {
      add("nonlinear_maxwell", "displacement", band, share);
      add("nonlinear_maxwell", "displacement", band, share, {{"power", {3.0}}});
    }
    for (const double share : {0.05, 0.25}) {
      add("sliding_maxwell", "yield_displacement", band, share);
    }
  }
}

// Adds flow whose rate grows with the excess of the force over a limit. The force reaches two to five times the limit.
void addOverstress(const fit::Excitation& excitation, std::vector<fit::BasisTerm>& terms) {
  for (const double share : {0.02, 0.07, 0.25}) {
    for (const double rate_share : {0.07, 0.3, 1.0}) {
      terms.push_back(fit::additiveTerm("overstress", "stiffness", 0.2 * excitation.stiffness,
                                        {{"yield_displacement", {share * excitation.largest_displacement}},
                                         {"reference_rate", {rate_share * excitation.highest_rate}}}));
    }
  }
}

void addRateAmplitudeCoupling(const fit::Excitation& excitation, fit::Candidate& candidate) {
  addFlow(excitation, candidate.terms);
  addOverstress(excitation, candidate.terms);
}

// Flow at a limit of the force is friction, and flow at any force is relaxation. The effect therefore contains both,
// and is named only if it explains the logs better than they do.
Effect rateAmplitudeCoupling() {
  Effect effect{160, "rate_amplitude_coupling",
                "flow of the rubber that large forces or fast motion accelerate: stiffness falls with amplitude, and "
                "falls more at higher frequency",
                false, addRateAmplitudeCoupling};
  effect.contains = {"friction", "relaxation"};
  return effect;
}

const EffectEntry kRateAmplitudeCoupling(rateAmplitudeCoupling());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
