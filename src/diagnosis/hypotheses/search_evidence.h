// What the judgement is told of a search.
#pragma once

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/judge/criteria.h"
#include "diagnosis/judge/evidence.h"
#include "rubber_suspension/io/rig_tolerances.h"

namespace rubber_suspension::diagnosis {

/// The numbers of a search, without errors on unseen logs.
Evidence evidenceOf(const Search& search);

/// What a sensor may be off by without anybody calling it a fault is told as what the rig did.
void markGainsWithinTolerance(const io::RigTolerance& tolerance, const Search& search, const Criteria& criteria,
                              Evidence& evidence);

}  // namespace rubber_suspension::diagnosis
