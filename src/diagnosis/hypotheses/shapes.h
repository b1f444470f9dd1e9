// Shape parameters of laws, such as a clearance, in which the force is not linear.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Gives each candidate with a shape parameter (fit::Candidate::terms_at) the terms at the value with the least error
/// beside the re-estimated model, as if the force were linear in all other parameters.
void settleShapes(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
                  const std::vector<gap::PreparedRecord>& records, int threads,
                  std::vector<fit::Candidate>& candidates);

/// A curve that a law may follow, and the error with it.
struct CurveLook {
  fit::Curve curve;
  double left = 0.0;
  double left_straight = 0.0;  ///< error of the law without a curve
};

/// Finds the curve with the least error for the law of a member of a fitted hypothesis, by normal equations about it.
/// Three terms represent the law with and without a curve, because curves do not depend on its spectrum.
CurveLook bestCurve(const fit::HypothesisFitter& fitter, const FittedHypothesis& about, const fit::Candidate& candidate,
                    int member, const std::vector<gap::PreparedRecord>& records, int threads);

}  // namespace rubber_suspension::diagnosis::hypotheses
