// A diagnosis whose statements have to agree with each other: what tests of this folder make goes through here.
#pragma once

#include <vector>

#include "diagnosis/invariants.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension {

inline diagnosis::Diagnosis checkedDiagnosis(const io::ComponentDescription& component,
                                             const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out,
                                             const diagnosis::DiagnosisOptions& options = {}) {
  diagnosis::Diagnosis result = diagnosis::diagnose(component, logs, hold_out, options);
  test::checkInvariants(result);
  return result;
}

}  // namespace rubber_suspension
