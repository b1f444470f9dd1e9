// The gap to expect on further logs of a rig: a posterior predictive of what a law leaves there.
#pragma once

#include <array>

#include "diagnosis/judge/answer.h"
#include "diagnosis/judge/score.h"

namespace rubber_suspension::diagnosis::results {

/// A hypothesis whose share in closing the gap is asked for.
struct Closing {
  int hypothesis = judge::Evidence::kReEstimated;
  double alone = 1.0;    ///< probability that nothing else is at work: then what it leaves is the form error of its law
  bool at_work = false;  ///< a law that is at work closes some of the gap
};

/// The effects and values that an answer names.
Closing closingOf(const judge::Answer& answer);

/// 95 % interval of the fraction of the gap that a hypothesis closes of as many further logs of the same rig as there
/// are.
///
/// The error that a law leaves in a log beyond its noise is normal with the variance v s^2, where s^2 is what the
/// judgement expects of it there (score.h). Of v the judgement knows what logs of one rig scatter by: beforehand an
/// inverse chi-square of nu degrees of freedom, after n logs with r^2 left of one of nu + n, so that what is left of a
/// further log is Student's t. Beside a rest, which may have any size, the logs alone tell v. Noise floors are off by
/// their standard error. Logs are drawn by their weights. Draws without a gap do not count, nor, of a law that is at
/// work, those in which it closes none of it; without any the interval is that from 0 to 1.
std::array<double, 2> closedOnFurtherLogs(const judge::ScoreTable& table, const Closing& closing, int draws,
                                          unsigned seed);

}  // namespace rubber_suspension::diagnosis::results
