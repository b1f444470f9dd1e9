// Approximate odds of hypotheses from their error over all logs, for the search.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "fit/hypothesis.h"
#include "measurement/rig_noise.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Weights like those of the judgement (judge/score.h), but over all logs together, and with the error that members
/// remove in place of the force that they add.
class Odds {
 public:
  /// `floor`: noise floor of all logs; `without`: error of the model without effects; both in units of the force's
  /// standard deviation. `blocks`: number of blocks of all logs.
  Odds(const std::vector<fit::Candidate>& candidates, double floor, double without, std::size_t blocks,
       std::size_t logs)
      : candidates_(candidates),
        floor_(floor),
        without_(without),
        blocks_(static_cast<double>(blocks)),
        logs_(static_cast<double>(logs)) {}

  /// Returns the log weight of a hypothesis with these scales. `error`: fit::Fit::score() or a comparable gap.
  double of(const fit::Hypothesis& hypothesis, const Eigen::VectorXd& scales, double error) const;

  /// Returns the log weight of a set of so many effects of usual rate that leaves only the noise floor.
  double mostOf(std::size_t effects) const;

 private:
  double ofError(double error) const;

  const std::vector<fit::Candidate>& candidates_;
  double floor_;
  double without_;
  double blocks_;
  double logs_;
};

/// Returns the fitted numbers of the judgement that concern the expected error of a model.
measurement::ErrorScale errorScale();

}  // namespace rubber_suspension::diagnosis::hypotheses
