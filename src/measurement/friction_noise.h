// The error of a model with Berg's friction by small reversals and by the time before a log.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::measurement {

/// Returns, for each log, the error of Berg's friction by small reversals, in units of the force's standard deviation;
/// zero for models without. The law forgets all but the last reversal, so one that is missed, or caused by noise,
/// shifts the force after it. The error is the RMS over some dead bands and draws of the sensor's noise. Other laws of
/// a model err by no more than the noise itself.
std::vector<double> frictionNoise(const std::vector<element::ElementDescription>& elements,
                                  const std::vector<gap::PreparedRecord>& records);

/// Returns, for each log, the force [N] by which Berg's friction differs over the log from a start at rest if the
/// component came from the log's highest displacement, and from its lowest: one column each, less its mean, which an
/// offset absorbs. Models without such friction, and excerpts, whose past is known, have no columns.
std::vector<Eigen::MatrixXd> frictionStarts(const std::vector<element::ElementDescription>& elements,
                                            const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::measurement
