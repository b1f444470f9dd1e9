// Residual force: a test whether it is a function of the motion, a surrogate that reproduces it, and its map over
// displacement and velocity.
#pragma once

#include <vector>

#include "fit/surrogate.h"
#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Logs that a surrogate is fitted to, and held-out logs.
struct SurrogateLogs {
  const std::vector<gap::PreparedRecord>& training;
  const gap::Forces& force;  ///< of the augmented component on `training`, from the displacement as recorded [N]
  const std::vector<gap::PreparedRecord>& held_out;
};

/// Fits a surrogate to the residual of a component, and judges whether the residual is a function of the motion: by its
/// prediction on logs (on blocks, if there are fewer than three logs) that it was not fitted to, and on held-out logs.
/// `noise_floor`: as a gap. Does not set Surrogate::gap.
Surrogate fitSurrogate(const io::ComponentDescription& component, const SurrogateLogs& logs, double noise_floor,
                       int threads);

/// Tests on held-out blocks whether the residual is a function of the motion, and computes the predicted share of its
/// square beyond the noise. `count_logs`: blocks of one log count as one.
void judgeRest(const std::vector<fit::UnseenBlock>& unseen, double noise_floor, bool count_logs, Surrogate& surrogate);

/// Returns the mean missing force of records, from the forces [N] of the augmented component without and with a
/// surrogate. Samples that do not count in the fit are ignored.
MissingForce missingForce(const std::vector<gap::PreparedRecord>& records, const gap::Forces& augmented,
                          const gap::Forces& surrogate);

}  // namespace rubber_suspension::diagnosis::results
