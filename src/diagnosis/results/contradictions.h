// What a report says that does not agree with its other numbers.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// A sentence for each pair of statements of a diagnosis that contradict each other; empty where all agree. What has to
/// hold: the verdict's answer is the likeliest; nothing leaves less than the noise floor; an effect is named only where
/// the gap on data that took no part in the fit falls for sure, or else stands beside wrong values that cannot be told
/// from it; a rest beyond the noise is `partly` or `unknown`; wrong values explain a gap only where no effect leaves
/// significantly less; the closed fraction is that of the gaps and lies in its interval.
std::vector<std::string> contradictions(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis
