// Numbers of a law that its force is not linear in, such as a clearance.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Give each candidate with such a number (fit::Candidate::terms_at) the terms at the value that leaves least beside
/// the re-estimated model, as if its force were linear in all else.
void settleShapes(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
                  const std::vector<gap::PreparedRecord>& records, int threads,
                  std::vector<fit::Candidate>& candidates);

/// A curve that a law may follow, and what it leaves of the logs.
struct CurveLook {
  fit::Curve curve;
  double left = 0.0;
  double left_straight = 0.0;  ///< with the law as it is
};

/// Finds the curve with the least error for the law of a member of a fitted hypothesis, by normal equations about it.
/// Three terms represent the law with and without a curve, because curves do not depend on its spectrum.
CurveLook bestCurve(const fit::HypothesisFitter& fitter, const FittedHypothesis& about, const fit::Candidate& candidate,
                    int member, const std::vector<gap::PreparedRecord>& records, int threads);

}  // namespace rubber_suspension::diagnosis::hypotheses
