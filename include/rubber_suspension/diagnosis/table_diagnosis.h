// The diagnosis of a measured table of stiffness and loss angle, in place of logs.
#pragma once

#include <cstddef>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::diagnosis {

/// Fewest rows for a diagnosis; fewer cannot test a hypothesis.
constexpr std::size_t kFewestRows = 6;

/// Diagnoses one component from a table. Search and judgement are those of logs; residuals are those of K*
/// (fit::gapOfTable()), and what takes no part in a fit are rows. Effects that no table shows are never named
/// (DiagnosedTable::never_shown). Throws std::invalid_argument for a table or a component that cannot be used.
Diagnosis diagnoseTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                        const DiagnosisOptions& options = {});

}  // namespace rubber_suspension::diagnosis
