// The error of a model with Berg's friction by small reversals and by the time before a log.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::measurement {

/// The error of Berg's friction by small reversals, for each log, in units of the force's standard deviation;
/// zero for models without. It forgets all but the last reversal, so one that is missed, or taken where none was,
/// shifts all that follows: root mean square over some dead bands and draws of the sensor's noise. Other laws of a
/// model err by no more than the noise itself.
std::vector<double> frictionNoise(const std::vector<element::ElementDescription>& elements,
                                  const std::vector<gap::PreparedRecord>& records);

/// The remains of a motion before each log in Berg's friction, which forgets it in the course of the log: the force
/// that it adds over the log where the component came from the highest displacement of it, and from the lowest [N], one
/// column each, less its mean, which is a zero. Without columns for models without such friction, and for excerpts,
/// whose past is known.
std::vector<Eigen::MatrixXd> frictionStarts(const std::vector<element::ElementDescription>& elements,
                                            const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::measurement
