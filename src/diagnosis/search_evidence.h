// What the judgement is told of a search.
#pragma once

#include <vector>

#include "diagnosis/judge/criteria.h"
#include "diagnosis/judge/evidence.h"
#include "diagnosis/search.h"
#include "rubber_suspension/io/rig_tolerances.h"

namespace rubber_suspension::diagnosis {

/// The numbers of a search, without errors on unseen logs.
Evidence evidenceOf(const Search& search);

/// For each effect the places of simpler ones that its law contains.
std::vector<std::vector<int>> containedIn(const std::vector<fit::Candidate>& candidates);

/// What a sensor may be off by without anybody calling it a fault is told as what the rig did.
void markGainsWithinTolerance(const io::RigTolerance& tolerance, const Search& search, const Criteria& criteria,
                              Evidence& evidence);

}  // namespace rubber_suspension::diagnosis
