// Definition of the gap between measured and simulated force, and of its part above the noise floor.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::gap {

/// RMS of measured minus simulated force over the standard deviation of the measured force [-]. `counts` is 1 for each
/// sample that counts, 0 where the force was not measured; empty: all count. Throws std::invalid_argument if the sizes
/// differ, or the measured force is empty or constant.
double relativeGap(const std::vector<double>& measured, const std::vector<double>& simulated,
                   const std::vector<double>& counts = {});

/// About the mean, of all values.
double standardDeviation(const Eigen::VectorXd& values);

/// The gap of a residual [N], by the standard deviation of the measured force [N].
double gapOfResidual(const Eigen::VectorXd& residual, double standard_deviation);

/// The part of a gap beyond a noise floor, both [-]: sqrt(gap^2 - floor^2), and 0 for a gap below the floor.
double residualAboveFloor(double gap, double floor);

/// Share of the closable gap, which is that above the floor, that a better model closes: 1 closes all, a negative one
/// opens the gap. At most kMostClosed; 0 where there is nothing to close.
double closedFraction(double before, double after, double floor);

/// More than all can be closed if the floor was overestimated.
constexpr double kMostClosed = 1.1;

/// Mean squared residual of a part of a log in units of its force's variance, the part's weight, and its log's place.
struct PartError {
  double error;
  double weight;
  int log = 0;
};

/// Gap over all parts: the root of the weighted mean of their squares.
double gapOfParts(const std::vector<PartError>& parts);

/// Unknowns of a single log, by their columns over its samples, and the penalty on their squares.
struct OwnUnknowns {
  Eigen::MatrixXd columns;
  Eigen::VectorXd penalty;
};

/// Tenths of each record, which counts by its weight (PreparedRecord::weight); samples that do not count are left out,
/// and so is what the rig may have added, and unknowns of the log: both as far as the other tenths tell them. `own`: of
/// each record; empty: there are none.
std::vector<PartError> partErrors(const std::vector<PreparedRecord>& records,
                                  const std::vector<Eigen::VectorXd>& simulated,
                                  const std::vector<OwnUnknowns>& own = {});

/// Returns the noise floor of a record from the residual of a model [N], as a gap: white noise above three times the
/// band of the displacement, but no more than the measured force itself has there (a mass that is driven by a noisy
/// displacement makes more).
double whiteNoiseFloor(const log::Record& record, const Eigen::VectorXd& residual);

}  // namespace rubber_suspension::gap
