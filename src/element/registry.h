// Registration of laws in the list of all laws.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Enters a law into the list, by a static object in the law's source file, at this place of the list and of the
/// reference page. Throws std::logic_error if another law has that place, which ends every program at its start.
struct ElementEntry {
  ElementEntry(int place, ElementType type);
};

}  // namespace rubber_suspension::element
