// The evidence that a search gives to the judgement.
#pragma once

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis {

/// The hypotheses of a search, each without what it leaves of logs and what its members add to them: of logs
/// addLogTable() tells, of a table addRows().
Evidence evidenceOf(const Search& search);

}  // namespace rubber_suspension::diagnosis
