// Which effects the logs of the fit speak for, before unseen logs are asked.
#pragma once

#include <cstddef>

#include "diagnosis/judge/judge.h"

namespace rubber_suspension::diagnosis {

/// `most_effects`: how many effects may be named at once; with 0 a gap is parameter_error or unknown. `trends`: whether
/// an effect that frees a slow trend per log may be named.
Judgement nameEffects(const Evidence& evidence, const Criteria& criteria, std::size_t most_effects, bool trends = true);

}  // namespace rubber_suspension::diagnosis
