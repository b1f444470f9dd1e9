// Computes errors of stiffness, loss angle and energy per cycle on logs, and these characteristics of a component.
#pragma once

#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the RMS errors over windows of twelve mean cycles: the relative error of the stiffness, the error of the
/// loss angle [rad] and the relative error of the energy loss. In each window, stiffness and loss angle describe the
/// part of the force that is coherent with the displacement; the energy is the integral of the force over the
/// displacement.
CharacteristicErrors characteristicErrors(const std::vector<gap::PreparedRecord>& records,
                                          const std::vector<Eigen::VectorXd>& simulated);

/// Returns stiffness and loss angle of the rubber, without elements of the rig, before and after the diagnosis, at the
/// nominal frequency and amplitude of `before`. If no nominal frequency is specified, the median of the mean
/// frequencies of the logs is used. If no nominal amplitude is specified, the median amplitude is used: of the logs
/// within an octave of the frequency, or of all logs if there are none. The loop is that of cycle 20, or an earlier one
/// that has settled.
std::optional<WholeStiffness> wholeStiffness(const io::ComponentDescription& before,
                                             const io::ComponentDescription& after,
                                             const std::vector<gap::PreparedRecord>& logs);

}  // namespace rubber_suspension::diagnosis::results
