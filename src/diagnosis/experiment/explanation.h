// The explanations of the same logs between which an experiment is to decide.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/hypotheses/workings.h"

namespace rubber_suspension::diagnosis {

/// A fitted hypothesis and how probable it is among those to decide between.
struct Explanation {
  const FittedHypothesis* fitted = nullptr;
  double probability = 0.0;
  double expected = 1e-4;  ///< square that it is expected to leave of a log (expectedSquares())
};

/// The hypothesis judged, then the likeliest others; the model as configured and re-estimated are among them.
std::vector<Explanation> explanationsOf(const Workings& workings);

/// Probabilities of explanations once there is one log more beside `logs`, of which each leaves these squares beyond
/// the noise: by the score of the judgement, in which all logs count alike.
std::vector<double> updated(const std::vector<Explanation>& explanations, const std::vector<double>& left, double logs);

/// "friction + creep"; "the model as it is" without members.
std::string nameOf(const Search& search, const FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis
