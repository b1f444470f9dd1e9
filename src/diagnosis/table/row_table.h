// Evidence by row of a table: each is a log under one sine.
#pragma once

#include "diagnosis/judge/evidence.h"
#include "diagnosis/table/measured_rows.h"

namespace rubber_suspension::diagnosis {

/// Adds the rows of a table to the evidence of a search: Evidence::logs, and log_errors and sizes of each hypothesis,
/// squares of differences of K* over |K*|.
void addRows(const MeasuredRows& measured, const Search& search, int threads, Evidence& evidence);

}  // namespace rubber_suspension::diagnosis
