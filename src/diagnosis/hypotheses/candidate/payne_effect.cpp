// Candidate effect: the Payne effect of filled rubber.
#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addPayneEffect(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const auto add = [&](const char* law, double cycles, double share, double band) {
    candidate.terms.push_back(fit::additiveTerm(law, "stiffness", 0.2 * excitation.stiffness,
                                                {{"break_frequency", {band * excitation.highest_frequency}},
                                                 {"recovery_time", {cycles / excitation.highest_frequency}},
                                                 {"travel", {share * excitation.largest_displacement}},
                                                 {"dead_band", {excitation.dead_band}}}));
  };
  // The stiffness recovers within 5 or 50 cycles of the fastest motion.
  for (const double cycles : {5.0, 50.0}) {
    for (const double share : {0.2, 0.7, 2.5}) {
      for (const double band : {0.003, 0.02, 0.15}) {
        add("payne_maxwell", cycles, share, band);
      }
    }
    for (const double share : {0.2, 0.7, 2.5}) {
      add("transient_network", cycles, share, 0.0);
    }
  }
}

// Over a long travel the effect resembles relaxation. It contains relaxation and is named only if it fits better.
Effect payneEffect() {
  Effect effect{165, "payne_effect",
                "Payne effect of filled rubber: stiffness falls during motion and recovers at rest", false,
                addPayneEffect};
  effect.contains = {"relaxation"};
  return effect;
}

const EffectEntry kPayneEffect(payneEffect());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
