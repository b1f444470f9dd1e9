// A data sheet as a YAML file, and the component file that follows from it.
#pragma once

#include <string>

#include "rubber_suspension/estimation/data_sheet.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::command {

/// Reads a data sheet and returns the component file that follows from it, with its derivation as comments on top.
///
/// The file is a map `data_sheet:` with `component` (a name), optionally `model`, `load` (compression or shear, needed
/// with shore_a), and quantities by the names of dataSheetParameters() and specificationParameters(): numbers in SI, or
/// text with a unit such as "40 mm".
/// Throws std::invalid_argument or std::runtime_error with file, key, value and what is accepted in one line.
std::string componentFileFromDataSheet(const std::string& path);

/// Reads the sheet from text; `source` stands for the file's name in errors.
std::string componentFileFromDataSheetText(const std::string& text, const std::string& source);

}  // namespace rubber_suspension::command
