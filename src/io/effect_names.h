// Names of the effects that a diagnosis knows, which a component file may rule out.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::io {

/// In the order of the alphabet. The diagnosis, which files know nothing of, has a candidate for each (a test
/// compares).
const std::vector<std::string>& effectNames();

}  // namespace rubber_suspension::io
