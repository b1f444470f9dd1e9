// Branches of relaxation, by themselves or along a curve, and where relaxation ends and creep begins.
#pragma once

#include <vector>

#include "fit/excitation.h"
#include "fit/hypothesis.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {

/// The relaxation time [s] beyond which relaxation is creep: thirty cycles of the fastest log, which is 5 s at 6 Hz; a
/// tenth of the longest log where that is shorter, so that a decade of creep shows; and no less than the slowest loop
/// takes. What is slower than the motion shows under a hold, but not in the loops; a slow test has slow loops.
double longestRelaxationTime(const fit::Excitation& excitation);

/// Gives a candidate a branch for each of these break frequencies [Hz], whose stiffness is of a typical size [N/m].
/// They may follow one curve in common: separate curves would also represent a nonlinear spring beside linear branches.
void addBranches(const std::vector<double>& frequencies, double typical, const fit::Excitation& excitation,
                 fit::Candidate& candidate);

}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
