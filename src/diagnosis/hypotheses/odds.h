// How much likelier one hypothesis is than another by what it leaves of all logs, as far as a search needs to know.
#pragma once

#include <cstddef>
#include <vector>

#include "fit/hypothesis.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// The weights of the judgement (judge/score.h) over all logs at once: what members add to the force is taken for what
/// they remove of the error.
class Odds {
 public:
  /// `floor`: noise of all logs; `without`: error of the model without effects. Both in units of the force's standard
  /// deviation.
  Odds(const std::vector<fit::Candidate>& candidates, double floor, double without)
      : candidates_(candidates), floor_(floor), without_(without) {}

  /// Logarithm of the weight of a set of effects that leaves this error, penalty included.
  double of(const std::vector<int>& members, double error) const;

  /// Most that any set of so many effects can have.
  double mostOf(std::size_t effects) const;

 private:
  double ofError(double error) const;

  const std::vector<fit::Candidate>& candidates_;
  double floor_;
  double without_;
};

}  // namespace rubber_suspension::diagnosis::hypotheses
