// Reads measured tables of stiffness and loss angle.
#pragma once

#include <string>
#include <vector>

#include "fit/table_fit.h"

namespace rubber_suspension::command {

/// Parses columns with a header: frequency, amplitude, stiffness and loss angle, each with its unit in the name, such
/// as "stiffness [kN/mm]", or as `export --format table` writes them; separated by commas, semicolons or tabs, with
/// decimal points or commas. Skips empty lines and those that begin with #. Rows with a preload need a column mean
/// displacement; a column temperature is optional. Throws std::runtime_error with `source` (the name of the file),
/// line, column, value and what is accepted.
fit::MeasuredTable parseTable(const std::string& text, const std::string& source);

/// Reads a file of at most 16 MiB; the table is named after the file, without folder and extension.
fit::MeasuredTable readTable(const std::string& path);

}  // namespace rubber_suspension::command
