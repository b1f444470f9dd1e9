// The diagnosis of a measured table of stiffness and loss angle, in place of logs.
#pragma once

#include <cstddef>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::diagnosis {

/// Smallest number of rows for a diagnosis; fewer rows cannot test a hypothesis.
constexpr std::size_t kFewestRows = 6;

/// Diagnoses one component from a table. Search and judgement are the same as for logs, with residuals of K*
/// (fit::gapOfTable()) and with rows held out. Effects that no table can show are never named
/// (DiagnosedTable::never_shown). Throws std::invalid_argument for a table or a component that cannot be used.
Diagnosis diagnoseTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                        const DiagnosisOptions& options = {});

}  // namespace rubber_suspension::diagnosis
