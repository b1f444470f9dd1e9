// Approximate odds of hypotheses, which the search derives from their error on all logs together.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "fit/hypothesis.h"
#include "measurement/rig_noise.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Log weights like those of the judgement (judge/score.h), but from the error on all logs together, and with a form
/// error that is a share of the error that effects remove, not of the force that they add.
class Odds {
 public:
  /// `floor` is the noise floor of all logs, and `without` is the error of the model without effects. Both are divided
  /// by the standard deviation of the force. `blocks` is the number of blocks of all logs.
  Odds(const std::vector<fit::Candidate>& candidates, double floor, double without, std::size_t blocks,
       std::size_t logs)
      : candidates_(candidates),
        floor_(floor),
        without_(without),
        blocks_(static_cast<double>(blocks)),
        logs_(static_cast<double>(logs)) {}

  /// Returns the log weight of a hypothesis with these scales. `error` is fit::Fit::score() or a comparable gap.
  double of(const fit::Hypothesis& hypothesis, const Eigen::VectorXd& scales, double error) const;

  /// Returns the log weight of a set with this number of effects, each of usual rate, whose error is the noise floor.
  double mostOf(std::size_t effects) const;

 private:
  double ofError(double error) const;

  const std::vector<fit::Candidate>& candidates_;
  double floor_;
  double without_;
  double blocks_;
  double logs_;
};

/// Returns the fitted numbers of the judgement that define the expected error of a model.
measurement::ErrorScale errorScale();

}  // namespace rubber_suspension::diagnosis::hypotheses
