// Candidate effect: friction or a damper that a clearance of its own leaves without force after each reversal.
#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis {
namespace {

// Dampers that blow off or are filled with what thins, and one with an orifice.
void addDampers(const fit::Excitation& excitation, double gap, double typical, std::vector<fit::BasisTerm>& terms) {
  const auto add = [&](double exponent, double share) {
    terms.push_back(fit::additiveTerm("power_dashpot_behind_play", "stiffness", typical,
                                      {{"displacement", {share * excitation.largest_displacement}},
                                       {"reference_rate", {excitation.highest_rate}},
                                       {"exponent", {exponent}},
                                       {"gap", {gap}}}));
  };
  add(0.5, 0.03);
  add(0.5, 0.15);
  add(2.0, 0.05);
}

// A small clearance looks like friction, like damping or like nothing: named only where they fail.
fit::Candidate backlash(const fit::Excitation& excitation) {
  fit::Candidate candidate{"backlash",
                           "friction or damper with a clearance of its own: no loss force for some travel after each "
                           "reversal, none at small amplitude",
                           true,
                           {}};
  candidate.last_resort = true;
  const double typical = 0.1 * excitation.stiffness;
  const double largest = excitation.largest_displacement;
  for (const double gap : {0.03, 0.08, 0.2}) {
    for (const double yield : {0.02, 0.1}) {
      candidate.terms.push_back(
          fit::additiveTerm("friction_behind_play", "stiffness", typical,
                            {{"yield_displacement", {yield * largest}}, {"gap", {gap * largest}}}));
    }
    candidate.terms.push_back(
        fit::additiveTerm("maxwell_behind_play", "stiffness", 3.0 * typical,
                          {{"break_frequency", {3.0 * excitation.highest_frequency}}, {"gap", {gap * largest}}}));
    addDampers(excitation, gap * largest, 3.0 * typical, candidate.terms);
  }
  return candidate;
}

const CandidateEntry kBacklashEntry(85, backlash);

}  // namespace
}  // namespace rubber_suspension::diagnosis
