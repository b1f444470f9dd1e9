// Logs that are read block by block, so that they need not fit into memory.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// Largest number of samples that LogSource::read() passes on at once.
constexpr std::size_t kLogBlock = 65536;

/// A log that can be read repeatedly, block by block.
class LogSource {
 public:
  /// Receives consecutive samples of a log and the place of the first in the log; returns false to end the reading.
  using Take = std::function<bool(const Log& block, std::size_t first)>;

  LogSource() = default;
  virtual ~LogSource() = default;
  LogSource(const LogSource&) = delete;
  LogSource& operator=(const LogSource&) = delete;

  /// Returns the name of the log, as Log::name.
  virtual std::string name() const = 0;

  /// Passes all samples to `take`, in SI units and checked as by checkLog(). Returns the notes, which are complete if
  /// all samples were read. Several threads may read at once. Throws LogError, and what `take` throws.
  virtual std::vector<std::string> read(const Take& take) const = 0;
};

using LogSources = std::vector<std::shared_ptr<const LogSource>>;

/// Returns a source of a log in memory, which has to outlive the source.
std::shared_ptr<const LogSource> sourceOf(const Log& log);

/// Returns a source that owns a log in memory.
std::shared_ptr<const LogSource> sourceOf(Log&& log);

/// Opens the log of a file. Text, HDF5 and RPC III of more than four blocks are read again each time and never kept in
/// memory; others are read once, as by readLog(). Throws LogError.
std::shared_ptr<const LogSource> openLog(const std::string& path, const LogFormat& format = {});

/// Opens the log of a file, or all its segments if the format requests them. Throws LogError.
LogSources openLogs(const std::string& path, const LogFormat& format = {});

}  // namespace rubber_suspension::log
