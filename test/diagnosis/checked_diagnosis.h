// A diagnosis whose statements have to agree with each other: what tests of this folder make goes through here.
#pragma once

#include <algorithm>
#include <string>
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

/// Whether an effect is told alone, or alone among what else may be.
inline bool mayBe(const diagnosis::Diagnosis& diagnosis, const std::string& effect) {
  const auto is = [&](const diagnosis::Alternative& other) {
    return other.effects == std::vector<std::string>{effect};
  };
  return diagnosis.effects == std::vector<std::string>{effect} ||
         std::any_of(diagnosis.alternatives.begin(), diagnosis.alternatives.end(), is);
}

}  // namespace rubber_suspension
