// What nobody explains: whether it is a function of the motion, and a component that closes it all the same.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/judge/judge.h"
#include "fit/surrogate.h"
#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// True for the verdicts that leave a rest.
bool needsSurrogate(Verdict verdict);

/// Logs that a surrogate is fitted to, and those that are not.
struct SurrogateLogs {
  const std::vector<log::Record>& training;
  const gap::Forces& force;  ///< of the augmented component on these, from the displacement as recorded [N]
  const std::vector<log::Record>& held_out;
};

/// A component with a surrogate, and what it leaves of blocks that it was not fitted to.
struct FittedSurrogate {
  io::ComponentDescription component;
  std::vector<fit::UnseenBlock> of_logs;      ///< of the logs of the fit, each log or block left out in turn
  std::vector<fit::UnseenBlock> of_held_out;  ///< of the logs held out
  bool count_logs = false;                    ///< there are enough logs for blocks of one log to count as one
};

/// Fit a surrogate to what a component leaves.
FittedSurrogate fitSurrogate(const io::ComponentDescription& component, const SurrogateLogs& logs, int threads);

/// Judge whether the rest is a function of the motion: by what a surrogate predicts of logs (of blocks, where there are
/// fewer than three logs) that it was not fitted to, and of the logs held out. `noise_floor`: as a gap. Leaves
/// Surrogate::gap to be measured.
Surrogate judgeSurrogate(FittedSurrogate fitted, double noise_floor);

/// Part of the squared rest beyond the noise that a surrogate predicts, of the logs of the fit or of all: the larger
/// one, since what holds for a log that was left out is a function of the motion there.
double shareOfMotion(const FittedSurrogate& fitted, double noise_floor);

/// Whether blocks that took no part in the fit show the rest to be a function of the motion, and the share of the
/// squared rest beyond the noise that is. `count_logs`: blocks of one log count as one.
void judgeRest(const std::vector<fit::UnseenBlock>& unseen, double noise_floor, bool count_logs, Surrogate& surrogate);

/// One sentence, for the verdict.
std::string describeRest(const Surrogate& surrogate);

}  // namespace rubber_suspension::diagnosis
