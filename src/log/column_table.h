// Makes a log from a file that stores whole columns (MATLAB, HDF5), unlike text, which stores rows.
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

/// Functions that read the columns of a file. They identify a column by its index and use its name for errors only.
/// They throw std::runtime_error if a column cannot be read.
struct ColumnFile {
  /// Returns the number of values in a column.
  std::function<std::size_t(std::size_t place, const std::string& name)> length;
  /// Returns the numbers [first, first + count) of a column, as in the file.
  std::function<std::vector<double>(std::size_t place, const std::string& name, std::size_t first, std::size_t count)>
      read;
  /// Returns the same range of a column of time, which may count nanoseconds since 1970. If null, `read` is used.
  std::function<std::vector<long double>(std::size_t place, const std::string& name, std::size_t first,
                                         std::size_t count)>
      read_time = {};
};

constexpr std::size_t kAllSamples = std::numeric_limits<std::size_t>::max();

/// The columns of a file, and the group or struct that contains each column.
struct ColumnTable {
  std::vector<ColumnName> names;
  std::vector<std::string> groups;  ///< one group for each name
  ColumnFile file;
  const char* place = "element";  ///< word for a position in a column, for errors and notes
  bool is_own = false;            ///< true if this package wrote the columns, so that no note has to describe them
};

/// Finds the columns of the only log, or of the segment that the format selects. Passes the checked samples to `take`
/// in blocks of `block` samples. Returns the notes. Throws std::runtime_error that names column and element.
std::vector<std::string> blocksFromColumns(const ColumnTable& table, const LogFormat& format, const std::string& name,
                                           std::size_t block, const LogSource::Take& take);

/// Returns the log, or each segment if the format requests all. If several groups contain a log, each is a segment.
std::vector<Log> logsFromColumns(const ColumnTable& table, const LogFormat& format, const std::string& name);

}  // namespace rubber_suspension::log
