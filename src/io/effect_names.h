// Names of the effects that a diagnosis may name and a component file may rule out.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::io {

/// Returns the names in alphabetical order. They repeat the candidates of the diagnosis, on which this layer does not
/// depend; a test compares both lists.
const std::vector<std::string>& effectNames();

}  // namespace rubber_suspension::io
