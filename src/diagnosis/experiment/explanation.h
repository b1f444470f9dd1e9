// Competing explanations of the same logs, between which an experiment is to decide.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::experiment {

/// A fitted hypothesis and its probability among the explanations.
struct Explanation {
  const hypotheses::FittedHypothesis* fitted = nullptr;
  double probability = 0.0;
  double expected = 1e-4;   ///< mean expected squared residual of the logs (judge::expectedSquares())
  double loss = 0.0;        ///< mean of judge::lossOf() over the logs so far
  double usual_size = 0.0;  ///< size below which an effect is improbable (judge::usualSize())
  double sharpness = judge::fittedNumbers().sharpness;  ///< of the judgement (judge::sharpnessOf())
};

/// A wrong explanation after it has been refitted to the logs and a new log that follows from the right explanation.
struct Refitted {
  double left = 0.0;   ///< squared error on the new log; the right explanation has the error 0
  double prior = 0.0;  ///< change of the log prior of the sizes of its effects
};

/// Expected outcome of a diagnosis with one more log.
struct Outlook {
  double alone = 0.0;  ///< probability that the right explanation is then the only likely one
  double open = 0.0;   ///< entropy of the question which effects are at work, summed over the effects [bit]
};

/// Returns the judged hypothesis, then the likeliest others, which may be the configured or the re-estimated model.
std::vector<Explanation> explanationsOf(const Workings& workings);

std::vector<double> probabilitiesOf(const std::vector<Explanation>& explanations);

/// Returns the entropy of the question which effects are at work, if the explanations have these weights [bit]. An
/// effect that all explanations contain does not contribute to the entropy.
double openNames(const std::vector<Explanation>& explanations, const std::vector<double>& weights);

/// Returns the outlook if explanation `right` is right and one log is added to `logs` logs. All logs have the same
/// weight, so the weight of earlier logs decreases. The form error of the right explanation has the distribution that
/// the judgement assumes. `noise` is the additional squared noise of the new log.
Outlook outlookOf(std::size_t right, const std::vector<Explanation>& explanations,
                  const std::vector<Refitted>& refitted, double noise, double logs);

/// Returns a name such as "friction + creep"; "the model as configured" without members.
std::string nameOf(const hypotheses::Search& search, const hypotheses::FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis::experiment
