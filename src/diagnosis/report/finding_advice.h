// The meaning of a finding about the rig, and how to mend it at the bench.
#pragma once

#include <string>

namespace rubber_suspension::diagnosis {

struct FindingAdvice {
  std::string meaning;
  std::string remedy;
};

/// By the name that reports write. Of a name without an entry both are empty: the finding's own text says it.
const FindingAdvice& adviceOn(const std::string& finding);

}  // namespace rubber_suspension::diagnosis
