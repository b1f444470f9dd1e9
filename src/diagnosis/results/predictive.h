// Posterior predictive distribution of the gap on further logs of a rig.
#pragma once

#include <array>

#include "diagnosis/judge/answer.h"
#include "diagnosis/judge/score.h"

namespace rubber_suspension::diagnosis::results {

/// A hypothesis whose closed fraction of the gap is predicted.
struct Closing {
  int hypothesis = judge::Evidence::kReEstimated;
  double alone = 1.0;    ///< probability of no unlisted cause beside it: its residual is then the form error of its law
  bool at_work = false;  ///< it has effects, so that it closes some of the gap
};

/// Returns the hypothesis of an answer.
Closing closingOf(const judge::Answer& answer);

/// Returns the 95 % interval of the fraction of the gap that a hypothesis closes on as many further logs of the same
/// rig as there are logs.
///
/// The error of a law in a log beyond its noise is normal with the variance v s^2, where s^2 is what the judgement
/// expects there (score.h). The prior of v, the scatter between logs of one rig, is an inverse chi-square with nu
/// degrees of freedom; after n logs with squared errors r^2 it has nu + n, so that the error of a further log has
/// Student's t distribution. Beside an unlisted cause, whose force may have any size, only the logs determine v. Noise
/// floors vary by their standard error. Logs are drawn by their weights. Draws without a gap are discarded, and for a
/// hypothesis with effects those in which it closes nothing; the interval is 0 to 1 if none remain.
std::array<double, 2> closedOnFurtherLogs(const judge::ScoreTable& table, const Closing& closing, int draws,
                                          unsigned seed);

}  // namespace rubber_suspension::diagnosis::results
