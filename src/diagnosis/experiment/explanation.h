// The explanations of the same logs between which an experiment is to decide.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/hypotheses/workings.h"

namespace rubber_suspension::diagnosis::experiment {

/// A fitted hypothesis, with its probability among the explanations.
struct Explanation {
  const hypotheses::FittedHypothesis* fitted = nullptr;
  double probability = 0.0;
  double expected = 1e-4;   ///< expected squared residual of a log (judge::expectedSquares())
  double loss = 0.0;        ///< mean over the logs so far (judge::lossOf())
  double usual_size = 0.0;  ///< size below which a member is improbable
};

/// An explanation after a refit with one further log, for which another explanation is right.
struct Refitted {
  double left = 0.0;   ///< squared error in that log beyond that of the right explanation
  double prior = 0.0;  ///< change of the log prior of its members' sizes
};

/// Expected outcome of a diagnosis with one more log.
struct Outlook {
  double alone = 0.0;  ///< probability that the right explanation stands alone
  double open = 0.0;   ///< entropy of the names: for each effect, whether it is at work [bit]
};

/// Returns the judged hypothesis, then the likeliest others; the model as configured or re-estimated may be among them.
std::vector<Explanation> explanationsOf(const Workings& workings);

std::vector<double> probabilitiesOf(const std::vector<Explanation>& explanations);

/// Returns the entropy of the names if explanations have these weights [bit]. Sets that share an effect agree on it.
double openNames(const std::vector<Explanation>& explanations, const std::vector<double>& weights);

/// Returns the outlook if explanation `right` is right and one log is added to `logs` logs. All logs have the same
/// weight, so that earlier ones count less than before. The form error of the right explanation scatters as the
/// judgement expects. `noise`: additional squared error of the new log, if it has more noise.
Outlook outlookOf(std::size_t right, const std::vector<Explanation>& explanations,
                  const std::vector<Refitted>& refitted, double noise, double logs);

/// Returns a name such as "friction + creep"; "the model as it is" without members.
std::string nameOf(const hypotheses::Search& search, const hypotheses::FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis::experiment
