// Defines the gap between measured and simulated force, and its part above the noise floor.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::gap {

/// Returns the RMS of the measured minus the simulated force, divided by the standard deviation of the measured force
/// [-]. `counts` is 1 for each sample that counts and 0 where the force was not measured; if it is empty, all samples
/// count. Throws std::invalid_argument if the sizes differ, or if the measured force is empty or constant.
double relativeGap(const std::vector<double>& measured, const std::vector<double>& simulated,
                   const std::vector<double>& counts = {});

/// Returns the standard deviation of the values.
double standardDeviation(const Eigen::VectorXd& values);

/// Returns the gap of a residual [N], given the standard deviation of the measured force [N].
double gapOfResidual(const Eigen::VectorXd& residual, double standard_deviation);

/// Returns the part of a gap above a noise floor [-]: sqrt(gap^2 - floor^2), or 0 if the gap is below the floor.
double residualAboveFloor(double gap, double floor);

/// Returns (before - after) / (before - floor), the share of the gap above the noise floor that a better model closes.
/// The result is limited to -1 and kMostClosed. It is negative if the gap increases, and 0 if there is nothing to
/// close.
double closedFraction(double before, double after, double floor);

/// Upper limit of closedFraction(). It is greater than 1 because the floor may be overestimated.
constexpr double kMostClosed = 1.1;

/// Mean squared residual of a part of a log divided by the variance of the force, weight of the part, index of the log.
struct PartError {
  double error;
  double weight;
  int log = 0;
};

/// Returns the gap over all parts, the square root of the weighted mean of their errors.
double gapOfParts(const std::vector<PartError>& parts);

/// Columns of the fit parameters of a single log, one row per sample, and the penalties on the squared parameters.
struct OwnUnknowns {
  Eigen::MatrixXd columns;
  Eigen::VectorXd penalty;
};

/// Returns the errors of ten parts of each record, weighted by PreparedRecord::weight. Samples that do not count are
/// excluded. Errors of the rig and the parameters of the log are estimated from the other nine parts and removed. `own`
/// are the parameters of each record; if it is empty, there are none.
std::vector<PartError> partErrors(const std::vector<PreparedRecord>& records,
                                  const std::vector<Eigen::VectorXd>& simulated,
                                  const std::vector<OwnUnknowns>& own = {});

/// Returns the noise floor of a record as a gap. The floor is the white noise in the residual of a model [N] above
/// three times the highest frequency of the displacement, or above 0.3 times the sampling rate if that is lower. It is
/// no larger than the noise of the measured force there, because the force of a mass under a noisy displacement has
/// more noise.
double whiteNoiseFloor(const log::Record& record, const Eigen::VectorXd& residual);

}  // namespace rubber_suspension::gap
