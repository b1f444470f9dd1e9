// Tests whether the residual force is a function of the motion, fits a surrogate to it, and maps it over the motion.
#pragma once

#include <vector>

#include "fit/surrogate.h"
#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

struct SurrogateLogs {
  const std::vector<gap::PreparedRecord>& training;
  /// Force of the augmented component on `training`, simulated from the displacement as recorded [N].
  const gap::Forces& force;
  const std::vector<gap::PreparedRecord>& held_out;
};

/// Fits a surrogate to the residual of a component, and judges whether the residual is a function of the motion. The
/// test is whether surrogates predict the residual on logs that they were not fitted to (on blocks, if there are fewer
/// than three logs). `noise_floor` is in the unit of a gap. Surrogate::gap is not set.
Surrogate fitSurrogate(const io::ComponentDescription& component, const SurrogateLogs& logs, double noise_floor,
                       int threads);

/// Judges on unseen blocks whether the residual is a function of the motion, and computes which share of the squared
/// residual above the noise is predicted. If `count_logs` is true, all blocks of a log count as one.
void judgeRest(const std::vector<fit::UnseenBlock>& unseen, double noise_floor, bool count_logs, Surrogate& surrogate);

/// Returns the mean missing force in cells of displacement and velocity, from the forces [N] of the augmented component
/// without and with a surrogate. Samples that do not count in the fit are ignored.
MissingForce missingForce(const std::vector<gap::PreparedRecord>& records, const gap::Forces& augmented,
                          const gap::Forces& surrogate);

}  // namespace rubber_suspension::diagnosis::results
