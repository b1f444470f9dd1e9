// The list of all laws, which each file of this folder enters its law into.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Enters a law into the list: one static object in the law's own file does it. `place` is its place in the list and on
/// the reference page. Throws std::logic_error where another law has that place, which ends every program at its start.
struct ElementEntry {
  ElementEntry(int place, ElementType type);
};

}  // namespace rubber_suspension::element
