// Reference page of the component file, generated from the tables with which component files are checked.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// Returns the page as Markdown: models, keys of the specification and elements, with units, ranges and defaults.
std::string parameterReference();

}  // namespace rubber_suspension::io
