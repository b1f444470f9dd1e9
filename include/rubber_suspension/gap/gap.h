// Definition of the gap between measured and simulated force, and of its part above the noise floor.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::gap {

/// Returns the RMS of measured minus simulated force over the standard deviation of the measured force [-]. `counts` is
/// 1 for each sample that counts, 0 where the force was not measured; empty: all count. Throws std::invalid_argument if
/// the sizes differ, or the measured force is empty or constant.
double relativeGap(const std::vector<double>& measured, const std::vector<double>& simulated,
                   const std::vector<double>& counts = {});

/// Returns the standard deviation of the values about their mean.
double standardDeviation(const Eigen::VectorXd& values);

/// Returns the gap of a residual [N] relative to the standard deviation of the measured force [N].
double gapOfResidual(const Eigen::VectorXd& residual, double standard_deviation);

/// Returns the part of a gap beyond a noise floor, both [-]: sqrt(gap^2 - floor^2), and 0 for a gap below the floor.
double residualAboveFloor(double gap, double floor);

/// Returns the share of the closable gap, which is that above the floor, that a better model closes: 1 closes all, a
/// negative share opens the gap. From -1 to kMostClosed; 0 if there is nothing to close.
double closedFraction(double before, double after, double floor);

/// Upper limit of closedFraction(): it exceeds 1 because the floor may be overestimated.
constexpr double kMostClosed = 1.1;

/// Mean squared residual of a part of a log in units of its force's variance, the part's weight, and the log's index.
struct PartError {
  double error;
  double weight;
  int log = 0;
};

/// Returns the gap over all parts: the root of the weighted mean of their errors.
double gapOfParts(const std::vector<PartError>& parts);

/// Unknowns of a single log, by their columns over its samples, and the penalty on their squares.
struct OwnUnknowns {
  Eigen::MatrixXd columns;
  Eigen::VectorXd penalty;
};

/// Returns the errors of tenths of each record, which counts by its weight (PreparedRecord::weight). Samples that do
/// not count are excluded; errors of the rig and unknowns of the log are removed as far as the other tenths determine
/// them. `own`: unknowns of each record; empty: there are none.
std::vector<PartError> partErrors(const std::vector<PreparedRecord>& records,
                                  const std::vector<Eigen::VectorXd>& simulated,
                                  const std::vector<OwnUnknowns>& own = {});

/// Returns the noise floor of a record from the residual of a model [N], as a gap: white noise above three times the
/// band of the displacement, but no more than the measured force has there (the force of a mass with a noisy
/// displacement has more).
double whiteNoiseFloor(const log::Record& record, const Eigen::VectorXd& residual);

}  // namespace rubber_suspension::gap
