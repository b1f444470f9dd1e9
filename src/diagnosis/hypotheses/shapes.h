// Numbers of a law that its force is not linear in, such as a clearance.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Give each candidate with such a number (fit::Candidate::terms_at) the terms at the value that leaves least beside
/// the re-estimated model, as if its force were linear in all else.
void settleShapes(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
                  const std::vector<log::Record>& records, int threads, std::vector<fit::Candidate>& candidates);

}  // namespace rubber_suspension::diagnosis::hypotheses
