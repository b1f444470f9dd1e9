// The report's words on each log.
#pragma once

#include "diagnosis/results/taken_out.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis::results {

/// `noise`: its floor in units of the force's standard deviation; `account`: of what was taken out of it.
Admission admit(const log::Record& record, bool hold_out, double noise, const LogAccount& account);

}  // namespace rubber_suspension::diagnosis::results
