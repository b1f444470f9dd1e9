// What no motion causes, taken for noise.
#pragma once

#include "diagnosis/judge/criteria.h"
#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis {

/// True if the larger part of the gap is seen not to be a function of the motion.
bool motionCausesSmallerPart(const Evidence& evidence, const Criteria& criteria);

/// The same evidence with a noise floor of what no function of the motion predicts, neither a surrogate nor an effect:
/// what is left to be explained is what the motion causes.
Evidence withRestAsNoise(Evidence evidence, const Criteria& criteria);

/// True if a hypothesis closes more of the gap than what counts as explained, of unseen logs, too, and not by chance.
bool closesBeyondNoise(const Evidence& evidence, const Criteria& criteria, int hypothesis);

}  // namespace rubber_suspension::diagnosis
