// Branches of relaxation, with or without a curve, and the limit between relaxation and creep.
#pragma once

#include <vector>

#include "fit/excitation.h"
#include "fit/hypothesis.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {

/// Returns the relaxation time [s] beyond which relaxation is creep: thirty cycles of the fastest log (5 s at 6 Hz) or,
/// if that is shorter, a tenth of the longest log, so that a decade of creep is visible; at least the duration of the
/// slowest loop. Relaxation that is slower than the motion is visible under a hold, but not in the loops.
double longestRelaxationTime(const fit::Excitation& excitation);

/// Adds a branch of typical stiffness [N/m] for each of these break frequencies [Hz]. All branches follow the same
/// curve, if any: separate curves would also represent a nonlinear spring beside linear branches.
void addBranches(const std::vector<double>& frequencies, double typical, const fit::Excitation& excitation,
                 fit::Candidate& candidate);

}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
