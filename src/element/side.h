// The parameter `side` of elements that may act on one side of rest alone.
#pragma once

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::element {

/// 1, -1 or 0 for both. Throws std::invalid_argument for another value; `quantity` is the signal whose sign counts.
int sideOf(const ElementDescription& description, const char* quantity);

}  // namespace rubber_suspension::element
