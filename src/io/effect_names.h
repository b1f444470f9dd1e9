// Names of the effects that a diagnosis may name and a component file may rule out.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::io {

/// Returns the names in alphabetical order. The list repeats the candidates of the diagnosis, because this layer must
/// not depend on the diagnosis. A test compares both lists.
const std::vector<std::string>& effectNames();

}  // namespace rubber_suspension::io
