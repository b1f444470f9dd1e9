// Registration of laws in the list of all laws.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Enters a law into the list of all laws; a static object of this type is in the source file of each law. `place`
/// determines the order in the list and on the reference page. Throws std::logic_error if another law has that place,
/// which ends every program at its start.
struct ElementEntry {
  ElementEntry(int place, ElementType type);
};

}  // namespace rubber_suspension::element
