// A measured table of stiffness and loss angle: reading it.
#pragma once

#include <string>
#include <vector>

#include "fit/table_fit.h"

namespace rubber_suspension::command {

/// A text of columns with a header: frequency, amplitude, stiffness, loss angle, each with its unit in the name, as
/// "stiffness [kN/mm]", or as `export --format table` writes them; separated by commas, semicolons or tabs, with
/// decimal points. Lines that begin with # and empty ones are passed over. Throws std::runtime_error with `source`, the
/// name of the file, line, column, value and what is accepted. Rows with a preload need a column mean displacement; a
/// column temperature is read where there is one.
fit::MeasuredTable parseTable(const std::string& text, const std::string& source);

/// Reads a file of at most 16 MiB; the table has the name of the file without folder and extension.
fit::MeasuredTable readTable(const std::string& path);

}  // namespace rubber_suspension::command
