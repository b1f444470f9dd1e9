// Maxwell branches, and the relaxation time that separates relaxation from creep.
#pragma once

#include <vector>

#include "fit/excitation.h"
#include "fit/hypothesis.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {

/// Returns the relaxation time [s] above which relaxation is called creep. This is thirty cycles of the fastest log (5
/// s at 6 Hz) or, if that is shorter, a tenth of the longest log, so that a decade of creep is visible. It is at least
/// the duration of the slowest loop. Relaxation that is slower than the motion is visible while the displacement is
/// held, but not in the loops.
double longestRelaxationTime(const fit::Excitation& excitation);

/// Adds a Maxwell branch of typical stiffness [N/m] for each of these break frequencies [Hz]. If the stiffness
/// of the branches grows with the displacement, it grows by one curve for all branches, because separate curves would
/// also represent a nonlinear spring beside linear branches.
void addBranches(const std::vector<double>& frequencies, double typical, const fit::Excitation& excitation,
                 fit::Candidate& candidate);

}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
