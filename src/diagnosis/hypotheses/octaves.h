// Where in frequency a force has its energy.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::diagnosis::hypotheses {

/// Shares of octaves of frequency in the energy of evenly spaced samples: of their mean, then of the octaves from the
/// lowest frequency of the transform on (numerics::paddedSpectrum), so that they do not depend on the unit of time.
/// Empty where there is no energy or it is not finite.
std::vector<double> octaveShares(const Eigen::VectorXd& values);

}  // namespace rubber_suspension::diagnosis::hypotheses
