// The unexplained rest: whether it is a function of the motion, a component that closes it all the same, and a map of
// the force that a model lacks over displacement and velocity.
#pragma once

#include <vector>

#include "fit/surrogate.h"
#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Logs that a surrogate is fitted to, and those that are not.
struct SurrogateLogs {
  const std::vector<gap::PreparedRecord>& training;
  const gap::Forces& force;  ///< of the augmented component on these, from the displacement as recorded [N]
  const std::vector<gap::PreparedRecord>& held_out;
};

/// Fit a surrogate to what a component leaves, and judge whether that is a function of the motion: by what a surrogate
/// predicts of logs (of blocks, where there are fewer than three logs) that it was not fitted to, and of the logs held
/// out. `noise_floor`: as a gap. Leaves Surrogate::gap to be measured.
Surrogate fitSurrogate(const io::ComponentDescription& component, const SurrogateLogs& logs, double noise_floor,
                       int threads);

/// Tests on held-out blocks if the residual is a function of the motion, and finds the share of the squared residual
/// beyond the noise that is. `count_logs`: blocks of one log count as one.
void judgeRest(const std::vector<fit::UnseenBlock>& unseen, double noise_floor, bool count_logs, Surrogate& surrogate);

/// Mean missing force of records, from the forces [N] of the augmented component without and with a surrogate. Samples
/// that did not count in the fit do not count here.
MissingForce missingForce(const std::vector<gap::PreparedRecord>& records, const gap::Forces& augmented,
                          const gap::Forces& surrogate);

}  // namespace rubber_suspension::diagnosis::results
