// Candidate effect: a bracket or rig that yields.
#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::BasisTerm complianceTerm(const fit::Excitation& excitation, double closing_force, double side) {
  fit::BasisTerm term;
  term.at = [closing_force, side](double compliance) {
    element::ElementDescription entry{"series_compliance", {{"stiffness", {1.0 / compliance}}}};
    if (closing_force > 0.0) {
      entry.values["closing_force"] = {closing_force};
    } else {
      entry.values["side"] = {side};
    }
    return entry;
  };
  term.typical = 0.05 / excitation.stiffness;
  term.upper = 1.0 / excitation.stiffness;
  term.additive = false;
  term.refines = closing_force > 0.0;
  return term;
}

// One compliance for each side, and one that load takes away: together a mount that is uneven, hardens, or neither.
fit::Candidate seriesCompliance(const fit::Excitation& excitation) {
  constexpr double kClosing = 0.5;  // of the largest force
  const double closing_force = kClosing * excitation.stiffness * excitation.largest_displacement;
  return {"series_compliance",
          "rig, bracket or joint that yields, to both sides alike or not: error grows with stiffness whatever the "
          "frequency",
          true,
          {complianceTerm(excitation, 0.0, 1.0), complianceTerm(excitation, 0.0, -1.0),
           complianceTerm(excitation, closing_force, 0.0)}};
}

const CandidateEntry kSeriesComplianceEntry(110, seriesCompliance);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
