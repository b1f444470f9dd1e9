// Evidence as text: to judge it again with other criteria, without a simulation.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis {

/// Evidence and the names of the effects that it is about, schema rubber_suspension/evidence/2.
struct NamedEvidence {
  Evidence evidence;
  std::vector<std::string> effects;
};

std::string toJson(const NamedEvidence& named);

/// Throws std::invalid_argument for text that is not such evidence.
NamedEvidence parseEvidence(const std::string& text);

}  // namespace rubber_suspension::diagnosis
