// Approximate odds of hypotheses by their error on all logs, for the search.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "fit/hypothesis.h"
#include "measurement/rig_noise.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// The weights of the judgement (judge/score.h) over all logs at once: what members add to the force is taken for what
/// they remove of the error.
class Odds {
 public:
  /// `floor`: noise of all logs; `without`: error of the model without effects. Both in units of the force's standard
  /// deviation. `blocks`: of all logs.
  Odds(const std::vector<fit::Candidate>& candidates, double floor, double without, std::size_t blocks,
       std::size_t logs)
      : candidates_(candidates),
        floor_(floor),
        without_(without),
        blocks_(static_cast<double>(blocks)),
        logs_(static_cast<double>(logs)) {}

  /// Logarithm of the weight of a hypothesis at these scales that leaves this error, departure included.
  double of(const fit::Hypothesis& hypothesis, const Eigen::VectorXd& scales, double error) const;

  /// Most that any set of so many effects can have.
  double mostOf(std::size_t effects) const;

 private:
  double ofError(double error) const;

  const std::vector<fit::Candidate>& candidates_;
  double floor_;
  double without_;
  double blocks_;
  double logs_;
};

/// The judgement's numbers for how much a model may err, as fitted last.
measurement::ErrorScale errorScale();

}  // namespace rubber_suspension::diagnosis::hypotheses
