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
  double expected = 1e-4;   ///< square that it is expected to leave of a log (expectedSquares())
  double loss = 0.0;        ///< of the logs so far, on average (lossOf())
  double usual_size = 0.0;  ///< of a member, below which it is improbable
};

/// An explanation after a refit with one further log, of which another explanation is right.
struct Refitted {
  double left = 0.0;   ///< squared error in that log beyond that of the right explanation
  double prior = 0.0;  ///< further cost of its members' sizes, as a logarithm
};

/// Expectation for a diagnosis with one more log.
struct Outlook {
  double alone = 0.0;  ///< probability that the right explanation stands alone
  double open = 0.0;   ///< entropy of the names: of each effect, whether it is at work [bit]
};

/// The hypothesis judged, then the likeliest others; the model as configured and re-estimated are among them.
std::vector<Explanation> explanationsOf(const Workings& workings);

std::vector<double> probabilitiesOf(const std::vector<Explanation>& explanations);

/// Entropy of the names if explanations have these weights [bit]. Sets that share an effect agree on it.
double openNames(const std::vector<Explanation>& explanations, const std::vector<double>& weights);

/// Outlook if this explanation is right and there is one log more beside `logs`. All logs have the same weight, so that
/// earlier ones count less than before. The error of the right explanation, the form error of its law, scatters as the
/// judgement expects. `noise`: further squared error of the new log, if it has more noise.
Outlook outlookOf(std::size_t right, const std::vector<Explanation>& explanations,
                  const std::vector<Refitted>& refitted, double noise, double logs);

/// "friction + creep"; "the model as it is" without members.
std::string nameOf(const hypotheses::Search& search, const hypotheses::FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis::experiment
