// A log from a file of whole columns (MATLAB, HDF5), as opposed to rows of text.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "log/column_name.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::log {

/// Reads the columns of a file by their places; names are for errors. The functions throw std::runtime_error if a
/// column cannot be read.
struct ColumnFile {
  /// Returns the number of values of a column.
  std::function<std::size_t(std::size_t place, const std::string& name)> length;
  /// Returns the numbers [first, first + count) of a column, as in the file.
  std::function<std::vector<double>(std::size_t place, const std::string& name, std::size_t first, std::size_t count)>
      read;
  /// Reads a column of time, which may be nanoseconds since 1970; empty: as `read`.
  std::function<std::vector<long double>(std::size_t place, const std::string& name, std::size_t first,
                                         std::size_t count)>
      read_time = {};
};

constexpr std::size_t kAllSamples = std::numeric_limits<std::size_t>::max();

/// The columns of a file, with the group or struct that each belongs to.
struct ColumnTable {
  std::vector<ColumnName> names;
  std::vector<std::string> groups;  ///< one per name
  ColumnFile file;
  const char* place = "element";  ///< name of a place in a column, for errors and notes
  bool is_own = false;            ///< this package writes the columns, so that no note describes them
};

/// Finds the columns of the only log, or of the segment that the format selects, and passes those that are needed to
/// `take`, checked and in blocks of `block` samples. Returns the notes of readCsvLog(). Throws std::runtime_error that
/// names column, element and what is accepted.
std::vector<std::string> blocksFromColumns(const ColumnTable& table, const LogFormat& format, const std::string& name,
                                           std::size_t block, const LogSource::Take& take);

/// Returns the log, or each segment if the format requests all. Groups that each contain a log are segments.
std::vector<Log> logsFromColumns(const ColumnTable& table, const LogFormat& format, const std::string& name);

}  // namespace rubber_suspension::log
