// Candidate effect: friction or a damper behind a clearance, which has no force for some travel after each reversal.
#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// Returns the laws behind a clearance of width `gap`: friction, a linear damper, dampers with a relief valve or a
// shear-thinning fluid, and one with an orifice.
std::vector<fit::BasisTerm> clearanceTerms(const fit::Excitation& excitation, double gap) {
  const double typical = 0.1 * excitation.stiffness;
  const double largest = excitation.largest_displacement;
  std::vector<fit::BasisTerm> terms;
  for (const double yield : {0.006, 0.02, 0.06, 0.15, 0.35}) {
    terms.push_back(fit::additiveTerm("friction_behind_play", "stiffness", typical,
                                      {{"yield_displacement", {yield * largest}}, {"gap", {gap}}}));
  }
  terms.push_back(fit::additiveTerm("maxwell_behind_play", "stiffness", 3.0 * typical,
                                    {{"break_frequency", {3.0 * excitation.highest_frequency}}, {"gap", {gap}}}));
  const auto addDamper = [&](double exponent, double share) {
    terms.push_back(fit::additiveTerm("power_dashpot_behind_play", "stiffness", 3.0 * typical,
                                      {{"displacement", {share * largest}},
                                       {"reference_rate", {excitation.highest_rate}},
                                       {"exponent", {exponent}},
                                       {"gap", {gap}}}));
  };
  addDamper(0.5, 0.03);
  addDamper(0.5, 0.15);
  addDamper(2.0, 0.05);
  return terms;
}

void addBacklash(const fit::Excitation& excitation, fit::Candidate& candidate) {
  constexpr double kLeastGap = 0.01;  // divided by the largest displacement
  constexpr double kLargestGap = 0.5;
  candidate.is_friction = excitation.whole_logs > 1;
  candidate.least_shape = kLeastGap * excitation.largest_displacement;
  candidate.largest_shape = kLargestGap * excitation.largest_displacement;
  candidate.terms_at = [excitation](double gap) { return clearanceTerms(excitation, gap); };
  candidate.terms = candidate.terms_at(0.1 * excitation.largest_displacement);
}

Effect backlash() {
  Effect effect{85, "backlash",
                "friction or damper with a clearance of its own: no loss force for some travel after each reversal, "
                "and none at all at small amplitude",
                true, addBacklash};
  effect.contains = {"friction"};
  effect.labels = {{"gap", "gap on each side"}};
  return effect;
}

const EffectEntry kBacklash(backlash());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
