// A log from a file of whole columns (MATLAB, HDF5), as opposed to rows of text.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "log/column_name.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// The numbers of a column by its place, as the file has them; the name is for errors.
/// Throws std::runtime_error where they cannot be read.
using ReadColumn = std::function<std::vector<double>(std::size_t place, const std::string& name)>;

/// Find the columns, read those that are needed and make a log of them: checked, with the notes that readCsvLog gives.
/// Throws std::runtime_error that names column, element and what is accepted.
Log logFromColumns(const std::vector<ColumnName>& names, const ReadColumn& read, const LogFormat& format,
                   const std::string& name);

}  // namespace rubber_suspension::log
