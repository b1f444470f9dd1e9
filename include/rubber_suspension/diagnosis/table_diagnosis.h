// The diagnosis of a measured table of stiffness and loss angle, in place of logs.
#pragma once

#include <cstddef>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::diagnosis {

/// Smallest number of rows of a table that can be diagnosed; fewer rows cannot test a hypothesis.
constexpr std::size_t kFewestRows = 6;

/// Diagnoses one component from a table, as from logs: residuals are those of K* (fit::gapOfTable()), and rows are held
/// out. Effects that no table can show (DiagnosedTable::never_shown) are not named. Throws std::invalid_argument if the
/// table or the component cannot be used.
Diagnosis diagnoseTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                        const DiagnosisOptions& options = {});

}  // namespace rubber_suspension::diagnosis
