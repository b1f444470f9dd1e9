// Which effects the logs of the fit speak for, before unseen logs are asked.
#pragma once

#include <cstddef>
#include <set>

#include "diagnosis/judge/judge.h"

namespace rubber_suspension::diagnosis {

/// `most_effects`: how many effects may be named at once; with 0 a gap is parameter_error or unknown. `refuted`:
/// hypotheses that are out of question, because data that took no part in the fit speak against them.
Judgement nameEffects(const Evidence& evidence, const Criteria& criteria, std::size_t most_effects,
                      const std::set<int>& refuted);

}  // namespace rubber_suspension::diagnosis
