// The error of a model with Berg's friction due to small reversals and to unknown motion before a log.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::measurement {

/// Returns, for each log, the error of Berg's friction due to small reversals, in units of the force's standard
/// deviation; zero for models without this friction. The law remembers only the last reversal, so a reversal that is
/// missed, or caused by noise, shifts the force after it. The error is the RMS over several dead bands and simulated
/// noise of the sensor. Other laws of a model have errors no larger than the noise itself.
std::vector<double> frictionNoise(const std::vector<element::ElementDescription>& elements,
                                  const std::vector<gap::PreparedRecord>& records);

/// Returns, for each log, the changes [N] of Berg's friction over the log if the component came from the highest or the
/// lowest displacement of the log instead of from rest: one column each, without its mean, which an offset would
/// absorb. Models without such friction, and excerpts, whose earlier motion is known, have no columns.
std::vector<Eigen::MatrixXd> frictionStarts(const std::vector<element::ElementDescription>& elements,
                                            const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::measurement
