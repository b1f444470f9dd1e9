// Converts a data sheet in YAML to a component file.
#pragma once

#include <string>

#include "rubber_suspension/estimation/data_sheet.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::command {

/// Returns the component file that follows from a data sheet. Comments at its top explain the derivation.
///
/// The sheet is a map `data_sheet:` with `component` (a name), optionally `model`, `load` (compression or shear,
/// required with shore_a), and quantities with the names of dataSheetParameters() and specificationParameters():
/// numbers in SI units, or text with a unit such as "40 mm". Throws std::invalid_argument or std::runtime_error whose
/// text is one line with file, key, value and what is accepted.
std::string componentFileFromDataSheet(const std::string& path);

/// Does the same for the text of a sheet. Errors name `source` in place of the file.
std::string componentFileFromDataSheetText(const std::string& text, const std::string& source);

}  // namespace rubber_suspension::command
