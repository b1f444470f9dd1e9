// From a judged search over a table to what the report says.
#pragma once

#include <memory>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/table/measured_rows.h"
#include "rubber_suspension/diagnosis/table_diagnosis.h"

namespace rubber_suspension::diagnosis::table {

Diagnosis describeTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                        const MeasuredRows& measured, std::shared_ptr<const Workings> workings,
                        const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::table
