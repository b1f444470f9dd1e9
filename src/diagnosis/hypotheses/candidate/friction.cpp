// Candidate effect: friction of any smoothness, the same at any displacement or not, of any rate or reached with it.
#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::BasisTerm sliderTerm(double yield, double typical) {
  fit::BasisTerm term;
  term.typical = typical;
  term.at = [yield](double stiffness) {
    return element::ElementDescription{"iwan_table", {{"yield_displacement", {yield}}, {"stiffness", {stiffness}}}};
  };
  return term;
}

fit::Candidate friction(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "friction", "friction, a force with a limit: stiffness falls with amplitude at any frequency", false, {}};
  candidate.is_friction = excitation.whole_logs > 1;
  const double typical = 0.1 * excitation.stiffness;
  const double largest = excitation.largest_displacement;
  // Stop operators over the range of amplitudes: with stiffnesses of 0 or more they compose any friction that obeys
  // Masing's rule (Coulomb, Dahl, Iwan) and come close to those that nearly do (Berg, Bouc-Wen).
  for (const double share : {0.006, 0.015, 0.035, 0.075, 0.15, 0.27, 0.45, 0.7}) {
    candidate.terms.push_back(sliderTerm(share * largest, typical));
  }
  // Limits that grow fivefold up to the largest displacement.
  for (const double share : {0.006, 0.015, 0.035, 0.075, 0.15}) {
    candidate.terms.push_back(
        fit::additiveTerm("variable_friction", "stiffness", typical,
                          {{"yield_displacement", {share * largest}}, {"growth_displacement", {0.25 * largest}}}));
  }
  // Friction that wears within some cycles.
  for (const double share : {0.035, 0.15}) {
    candidate.terms.push_back(fit::additiveTerm("variable_friction", "stiffness", typical,
                                                {{"yield_displacement", {share * largest}},
                                                 {"travel", {40.0 * largest}},
                                                 {"dead_band", {excitation.dead_band}}}));
  }
  // Friction that comes to its limit with the rate: half of it at a rate well below the largest, since a force that
  // rises all the way to the largest rate is viscous damping.
  for (const double rate_share : {0.06, 0.2}) {
    for (const double share : {0.006, 0.035}) {
      candidate.terms.push_back(fit::additiveTerm(
          "viscoplastic_friction", "stiffness", typical,
          {{"yield_displacement", {share * largest}}, {"half_rate", {rate_share * excitation.highest_rate}}}));
    }
  }
  // A law of two numbers that forgets nothing under the noise of a sensor, as Berg's and Bouc and Wen's do.
  for (const double share : {0.003, 0.01, 0.03, 0.1, 0.3}) {
    candidate.laws.push_back(
        fit::additiveTerm("iwan", "maximum_force", typical * share * largest, {{"displacement", {share * largest}}}));
  }
  return candidate;
}

const CandidateEntry kFrictionEntry(10, friction);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
