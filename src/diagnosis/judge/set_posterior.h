// Probabilities of all sets of effects, each with and without an unlisted cause.
#pragma once

#include <vector>

#include "diagnosis/judge/score.h"

namespace rubber_suspension::diagnosis::judge {

struct SetProbability {
  std::vector<int> members;
  int hypothesis = 0;   ///< index of the hypothesis in the evidence
  double alone = 0.0;   ///< probability that these effects are the only cause
  double beside = 0.0;  ///< probability that these effects and an unlisted cause are at work
  /// Logarithm of the size of each effect. It is minus infinity for constant forces, which do not depend on the motion.
  std::vector<double> sizes = {};
  bool halves = false;  ///< result of halvesWhatIsLeft()

  double sum() const { return alone + beside; }
};

/// Probabilities of all answers, which add up to 1.
struct SetPosterior {
  double none = 0.0;                 ///< the model is right as configured
  double parameter_error = 0.0;      ///< the values of the model are wrong, and no effect is missing
  double unknown = 0.0;              ///< an unlisted cause is at work, without effects of the list
  std::vector<SetProbability> sets;  ///< sets of at least one effect, the likeliest first

  double ofSets() const;
};

/// Returns true if the squared error of a hypothesis on all logs is at most half of that of re-estimated values alone.
/// Returns false for inadmissible hypotheses, such as those that contain an excluded effect.
bool halvesWhatIsLeft(const ScoreTable& table, Eigen::Index hypothesis);

/// Returns a posterior in which `unknown` is 0 if any set halves the squared error of re-estimated values, because
/// unlisted causes alone do not explain such an error. The probability of `unknown` is distributed over these sets in
/// proportion to their own probabilities, and is added to `beside`.
SetPosterior toldByHalving(SetPosterior posterior);

SetPosterior setPosterior(const ScoreTable& table, const JudgeNumbers& numbers);

}  // namespace rubber_suspension::diagnosis::judge
