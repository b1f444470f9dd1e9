// Which effects the logs of the fit speak for, before unseen logs are asked.
#pragma once

#include <set>

#include "diagnosis/judge/judge.h"

namespace rubber_suspension::diagnosis {

/// `refuted`: hypotheses that are out of question, because data that took no part in the fit speak against them.
Judgement nameEffects(const Evidence& evidence, const Criteria& criteria, const std::set<int>& refuted);

}  // namespace rubber_suspension::diagnosis
