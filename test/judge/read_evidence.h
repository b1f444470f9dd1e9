// Reads the evidence of a diagnosis from a file, to judge it again.
#pragma once

#include <string>

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis {

/// Parses evidence as toJson() writes it. Throws std::invalid_argument for other text and for older schemas.
judge::Evidence parseEvidence(const std::string& text);

}  // namespace rubber_suspension::diagnosis
