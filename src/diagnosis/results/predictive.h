// Computes the posterior predictive distribution of the gap on further logs of a rig.
#pragma once

#include <array>

#include "diagnosis/judge/answer.h"
#include "diagnosis/judge/score.h"

namespace rubber_suspension::diagnosis::results {

/// A hypothesis for which the closed fraction of the gap is predicted.
struct Closing {
  int hypothesis = judge::Evidence::kReEstimated;
  /// Probability that no unlisted cause acts beside the hypothesis, whose residual is then the form error of its law.
  double alone = 1.0;
  bool at_work = false;  ///< true if the hypothesis has effects, so that it closes some of the gap
};

/// Returns the hypothesis of an answer, with the probability that there is no unlisted cause.
Closing closingOf(const judge::Answer& answer);

/// Returns the 95 % interval of the fraction of the gap that a hypothesis closes on as many further logs of the same
/// rig as there are logs.
/// The squared error of a law in a log, above the noise, is modelled as v s^2 times the square of a standard normal
/// variable, where s^2 is the error that the judgement expects in that log (score.h). The factor v describes the
/// scatter between the logs of a rig. Its prior is an inverse chi-square distribution with nu degrees of freedom. Its
/// posterior after n logs has nu + n degrees of freedom, so that the error of a further log has Student's t
/// distribution. If there is an unlisted cause, whose force may have any size, v has no prior (nu = 0). Noise floors
/// vary by their standard error. Logs are drawn with the probabilities of their weights. Draws without a gap are
/// discarded, as are draws in which a hypothesis with effects closes nothing. If no draw remains, the interval is 0 to
/// 1.
std::array<double, 2> closedOnFurtherLogs(const judge::ScoreTable& table, const Closing& closing, int draws,
                                          unsigned seed);

}  // namespace rubber_suspension::diagnosis::results
