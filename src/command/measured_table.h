// Reads measured tables of stiffness and loss angle.
#pragma once

#include <string>
#include <vector>

#include "fit/table_fit.h"

namespace rubber_suspension::command {

/// Parses a table whose header names frequency, amplitude, stiffness and loss angle with their units, such as
/// "stiffness [kN/mm]", or the columns that `export --format table` writes. Commas, semicolons, tabs or blanks separate
/// the columns; numbers have decimal points or commas. Empty lines and lines that begin with # are skipped. Rows with a
/// preload need a column of the mean displacement; a column of temperature is optional. Throws std::runtime_error with
/// `source` (the name of the file), line, column, value and what is accepted.
fit::MeasuredTable parseTable(const std::string& text, const std::string& source);

/// Reads a file of at most 16 MiB. The name of the table is the file name without folder and extension.
fit::MeasuredTable readTable(const std::string& path);

}  // namespace rubber_suspension::command
