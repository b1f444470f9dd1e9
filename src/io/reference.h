// The reference page of the component file, written from the tables that check it.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// Markdown: models, keys of the specification and elements, with units, ranges and defaults.
std::string parameterReference();

}  // namespace rubber_suspension::io
