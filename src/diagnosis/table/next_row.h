// The row to measure next where the diagnosis is of a table.
#pragma once

#include <string>

#include "diagnosis/results/workings.h"
#include "diagnosis/table/measured_rows.h"

namespace rubber_suspension::diagnosis {

/// The row, within the range of the table or up to twice as far, in which the explanations that compete differ most; or
/// that no row tells them apart, and a log is needed.
std::string nextRow(const MeasuredRows& measured, const Workings& workings);

}  // namespace rubber_suspension::diagnosis
