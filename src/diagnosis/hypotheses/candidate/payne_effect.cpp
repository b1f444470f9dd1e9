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
  // Recovery from some cycles of the fastest motion to the slowest motion. Where the travel is well above the
  // displacement, these are Maxwell elements.
  for (const double cycles : {3.0, 15.0, 75.0}) {
    for (const double share : {0.2, 0.6, 1.8}) {
      for (const double band : {0.004, 0.04}) {
        add("payne_maxwell", cycles, share, band);
      }
      add("transient_network", cycles, share, 0.0);
    }
  }
}

const EffectEntry kPayneEffect({165, "payne_effect",
                                "Payne effect of filled rubber: stiffness falls while motion lasts and returns at rest",
                                false, addPayneEffect});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
