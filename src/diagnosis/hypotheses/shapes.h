// Finds the values of parameters of laws, such as a clearance, in which the force is not linear.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Finds, for each candidate with such a parameter (fit::Candidate::terms_at), the value with the least error, and sets
/// the terms of the candidate to those at this value. Errors follow from normal equations about the re-estimated model.
void settleShapes(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
                  const std::vector<gap::PreparedRecord>& records, int threads,
                  std::vector<fit::Candidate>& candidates);

/// A curve that a law may follow, and the errors with and without it.
struct CurveLook {
  fit::Curve curve;
  double left = 0.0;
  double left_straight = 0.0;  ///< error of the law without a curve
};

/// Finds the curve with the least error for the law of one effect of a fitted hypothesis, by means of normal equations
/// about this hypothesis. Only three terms represent the law, because the best curve does not depend on its spectrum.
CurveLook bestCurve(const fit::HypothesisFitter& fitter, const FittedHypothesis& about, const fit::Candidate& candidate,
                    int member, const std::vector<gap::PreparedRecord>& records, int threads);

}  // namespace rubber_suspension::diagnosis::hypotheses
