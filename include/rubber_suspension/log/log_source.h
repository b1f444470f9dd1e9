// A log that is read block by block, so that its length does not matter.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// Samples that are handed out at once, at most.
constexpr std::size_t kLogBlock = 65536;

/// A log that is read as often as asked for, block by block.
class LogSource {
 public:
  /// Samples of a log that follow one another, the first of them at this place in the log; false ends the reading.
  using Take = std::function<bool(const Log& block, std::size_t first)>;

  LogSource() = default;
  virtual ~LogSource() = default;
  LogSource(const LogSource&) = delete;
  LogSource& operator=(const LogSource&) = delete;

  /// As that of a Log.
  virtual std::string name() const = 0;

  /// Passes the samples on from the first one, in SI units and checked as by checkLog(); returns the notes, complete if
  /// all was read. Several threads may read at once. Throws LogError, and what `take` throws.
  virtual std::vector<std::string> read(const Take& take) const = 0;
};

using LogSources = std::vector<std::shared_ptr<const LogSource>>;

/// A log in memory, which has to outlive the source.
std::shared_ptr<const LogSource> sourceOf(const Log& log);

/// A log in memory that belongs to the source.
std::shared_ptr<const LogSource> sourceOf(Log&& log);

/// A log by its file: text and HDF5 of more than four blocks are read again each time and never kept; anything else is
/// read once, as by readLog(). Throws LogError.
std::shared_ptr<const LogSource> openLog(const std::string& path, const LogFormat& format = {});

/// Opens all segments, if the format asks for them.
LogSources openLogs(const std::string& path, const LogFormat& format = {});

}  // namespace rubber_suspension::log
