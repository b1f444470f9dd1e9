// Stiffness, loss angle and energy per cycle: their errors over logs, and those of the whole component at one point.
#pragma once

#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the RMS over windows of twelve mean cycles of the relative error of stiffness, the error of the loss angle
/// [rad] and the relative error of the energy lost. Each window is one loop: stiffness and loss angle are those of the
/// part of the force that is coherent with the displacement, the energy is the integral of force over displacement.
CharacteristicErrors characteristicErrors(const std::vector<gap::PreparedRecord>& records,
                                          const std::vector<Eigen::VectorXd>& simulated);

/// Returns stiffness and loss angle of the rubber, without elements of the rig, at the nominal frequency and amplitude
/// of `before`. Without such a frequency it is the median of the mean frequencies of the logs; without such an
/// amplitude, the median amplitude of the logs within an octave of the frequency, or of all if there are none. The loop
/// is that of cycle 20, or an earlier one if it has settled.
std::optional<WholeStiffness> wholeStiffness(const io::ComponentDescription& before,
                                             const io::ComponentDescription& after,
                                             const std::vector<gap::PreparedRecord>& logs);

}  // namespace rubber_suspension::diagnosis::results
