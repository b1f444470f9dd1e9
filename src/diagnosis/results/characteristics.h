// Errors of stiffness, loss angle and energy per cycle between measured and simulated force.
#pragma once

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// RMS over windows of a dozen mean cycles of the relative error of stiffness, the error of the loss angle and the
/// relative error of the energy lost, each window taken as one loop: stiffness and loss angle from the force's part
/// that is coherent with the displacement, the energy from the integral of force over displacement.
CharacteristicErrors characteristicErrors(const std::vector<log::Record>& records,
                                          const std::vector<Eigen::VectorXd>& simulated);

}  // namespace rubber_suspension::diagnosis::results
