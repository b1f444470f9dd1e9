// Probabilities of all sets of effects, alone and beside a residual force of unlisted cause.
#pragma once

#include <vector>

#include "diagnosis/judge/score.h"

namespace rubber_suspension::diagnosis::judge {

/// A set of effects.
struct SetProbability {
  std::vector<int> members;
  int hypothesis = 0;   ///< its index in the evidence
  double alone = 0.0;   ///< probability that nothing else is at work
  double beside = 0.0;  ///< probability beside a residual force
  /// Logarithm of the size of each member; minus infinity for constants, which do not depend on the motion.
  std::vector<double> sizes = {};
  bool halves = false;  ///< halvesWhatIsLeft()

  double sum() const { return alone + beside; }
};

/// Probabilities of all answers, which add up to 1.
struct SetPosterior {
  double none = 0.0;                 ///< the model is right as configured
  double parameter_error = 0.0;      ///< the values of the model are wrong, and no effect is missing
  double unknown = 0.0;              ///< an unlisted cause alone
  std::vector<SetProbability> sets;  ///< of one effect or more, the likeliest first

  double ofSets() const;
};

/// Returns true if the squared residual of a hypothesis over all logs is at most half of that with re-estimated values
/// alone. False for inadmissible hypotheses, such as those with an excluded or an idle effect.
bool halvesWhatIsLeft(const ScoreTable& table, Eigen::Index hypothesis);

/// Returns a posterior in which the sets that halve the residual of re-estimated values, if any, receive the
/// probability of `unknown` in proportion to theirs, each beside a residual force: a residual that a set halves is not
/// due to unlisted causes alone.
SetPosterior toldByHalving(SetPosterior posterior);

SetPosterior setPosterior(const ScoreTable& table, const JudgeNumbers& numbers);

}  // namespace rubber_suspension::diagnosis::judge
