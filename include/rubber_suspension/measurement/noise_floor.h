// The gap that noise alone leaves, from what the motion does not cause. Throws nothing.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/faults.h"
#include "rubber_suspension/measurement/noise_model.h"

namespace rubber_suspension::measurement {

/// Standard deviation of the noise [N] in what the best model leaves of a record, its rig's part taken out: by repeats
/// of the same cycle, else by the spectrum beside the motion, else where the displacement stands still. Never above
/// what a model leaves; never below what the force's resolution allows. `slow_noise`: most that is slower than the
/// motion and still noise [N].
double noiseFloor(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask,
                  double slow_noise = std::numeric_limits<double>::infinity());

/// The law of the noise in such a residual [N], where the band of the motion holds nothing else: what a model errs by
/// follows no law that holds beside the motion as well.
std::optional<NoiseModel> noiseAlone(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask);

/// The floor of what a model leaves of a record, as a gap [-]; the rig's part and samples that do not count are taken
/// out first.
double relativeFloor(const gap::PreparedRecord& record, const Eigen::VectorXd& residual);

}  // namespace rubber_suspension::measurement
