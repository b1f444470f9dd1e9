// Where in frequency a force has its energy.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::diagnosis {

/// Shares of octaves of frequency in the energy of samples `dt` [s] apart: below 1/16 Hz, with their mean, the octaves
/// from there, and all above 256 Hz. Empty where there is no energy or it is not finite.
std::vector<double> octaveShares(const Eigen::VectorXd& values, double dt);

}  // namespace rubber_suspension::diagnosis
