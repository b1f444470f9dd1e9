// The style of a component file that has each number as it was rounded.
#pragma once

#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Writes each of these numbers as its text has it. Refers to them.
io::YamlStyle styleOf(const std::vector<SizedValue>& written);

}  // namespace rubber_suspension::diagnosis
