// Probabilities of every set of effects, alone and beside a rest that no listed effect causes.
#pragma once

#include <vector>

#include "diagnosis/judge/score.h"

namespace rubber_suspension::diagnosis::judge {

/// A set of effects.
struct SetProbability {
  std::vector<int> members;
  int hypothesis = 0;   ///< of the evidence
  double alone = 0.0;   ///< nothing else is at work
  double beside = 0.0;  ///< beside a rest
  /// Logarithm of the size of each member, minus infinity for constants: those are no part of the motion.
  std::vector<double> sizes = {};
  bool halves = false;  ///< halvesWhatIsLeft()

  double sum() const { return alone + beside; }
};

/// All of these add up to 1.
struct SetPosterior {
  double none = 0.0;                 ///< the model is right as configured
  double parameter_error = 0.0;      ///< its values are wrong, and nothing is missing
  double unknown = 0.0;              ///< something that is not in the list, and nothing of it
  std::vector<SetProbability> sets;  ///< of one effect or more, the likeliest first

  double ofSets() const;
};

/// True if a hypothesis leaves no more than half of the square that re-estimated values leave of all logs. What is no
/// answer, as with an excluded effect or one that removes nothing, does not count.
bool halvesWhatIsLeft(const ScoreTable& table, Eigen::Index hypothesis);

/// A posterior in which, if some sets halve the residual of re-estimated values, these sets receive the probability of
/// `unknown` in proportion to theirs, each beside a residual force: a residual that a set halves is not due to unlisted
/// causes alone.
SetPosterior toldByHalving(SetPosterior posterior);

SetPosterior setPosterior(const ScoreTable& table, const JudgeNumbers& numbers);

}  // namespace rubber_suspension::diagnosis::judge
