// Evidence of a diagnosis from its file, to judge it again.
#pragma once

#include <string>

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis {

/// As toJson() writes it; reads schema 3, too. Throws std::invalid_argument for text that is not such evidence.
judge::Evidence parseEvidence(const std::string& text);

}  // namespace rubber_suspension::diagnosis
