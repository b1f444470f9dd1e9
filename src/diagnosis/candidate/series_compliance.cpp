// Candidate effect: a bracket or rig that yields.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {
namespace {

fit::Atom mountAtom(const fit::Excitation& excitation, double closing_force, double side) {
  fit::Atom atom;
  atom.at = [closing_force, side](double compliance) {
    element::ElementDescription entry{"series_compliance", {{"stiffness", {1.0 / compliance}}}};
    if (closing_force > 0.0) {
      entry.values["closing_force"] = {closing_force};
    } else {
      entry.values["side"] = {side};
    }
    return entry;
  };
  atom.typical = 0.05 / excitation.stiffness;
  atom.upper = 1.0 / excitation.stiffness;
  atom.additive = false;
  atom.refines = closing_force > 0.0;
  return atom;
}

}  // namespace

// One compliance for each side, and one that load takes away: together a mount that is uneven, hardens, or neither.
fit::Candidate seriesComplianceCandidate(const fit::Excitation& excitation) {
  constexpr double kClosing = 0.5;  // of the largest force
  const double closing_force = kClosing * excitation.stiffness * excitation.largest_displacement;
  return {
      "series_compliance",
      "rig, bracket or joint that yields, to both sides alike or not: error grows with stiffness whatever the "
      "frequency",
      true,
      {mountAtom(excitation, 0.0, 1.0), mountAtom(excitation, 0.0, -1.0), mountAtom(excitation, closing_force, 0.0)},
      false};
}

}  // namespace rubber_suspension::diagnosis
