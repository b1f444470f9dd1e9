// Branches of relaxation, by themselves or along a curve.
#pragma once

#include <vector>

#include "fit/excitation.h"
#include "fit/hypothesis.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {

/// Gives a candidate a branch for each of these break frequencies [Hz], whose stiffness is of a typical size [N/m].
/// They may follow one curve, all the same: a curve for each would be a nonlinear spring beside linear branches as
/// well.
void addBranches(const std::vector<double>& frequencies, double typical, const fit::Excitation& excitation,
                 fit::Candidate& candidate);

}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
