// The explanations of the same logs between which an experiment is to decide.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/hypotheses/workings.h"

namespace rubber_suspension::diagnosis::experiment {

/// A fitted hypothesis and how probable it is among those to decide between.
struct Explanation {
  const hypotheses::FittedHypothesis* fitted = nullptr;
  double probability = 0.0;
  double expected = 1e-4;  ///< square that it is expected to leave of a log (expectedSquares())
  double loss = 0.0;       ///< of the logs so far, on average (lossOf())
};

/// The hypothesis judged, then the likeliest others; the model as configured and re-estimated are among them.
std::vector<Explanation> explanationsOf(const Workings& workings);

/// How probable it is that an explanation stands alone, were it right, once there is one log more beside `logs`, of
/// which others leave these squares `more` than it does. All logs count alike, so that those so far tell less than
/// before. What the right one leaves itself, the form error of its law, scatters as the judgement expects.
double standsAlone(std::size_t right, const std::vector<Explanation>& explanations, const std::vector<double>& more,
                   double logs);

/// "friction + creep"; "the model as it is" without members.
std::string nameOf(const hypotheses::Search& search, const hypotheses::FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis::experiment
