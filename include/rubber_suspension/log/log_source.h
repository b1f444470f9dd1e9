// Logs that are read block by block, so that they need not fit into memory.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// Largest number of samples that LogSource::read() passes on in one call.
constexpr std::size_t kLogBlock = 65536;

/// A log that can be read repeatedly, block by block.
class LogSource {
 public:
  /// Receives consecutive samples and the index of the first of them in the whole log. Returns false to stop reading.
  using Take = std::function<bool(const Log& block, std::size_t first)>;

  LogSource() = default;
  virtual ~LogSource() = default;
  LogSource(const LogSource&) = delete;
  LogSource& operator=(const LogSource&) = delete;

  /// Returns the name of the log, as in Log::name.
  virtual std::string name() const = 0;

  /// Passes all samples to `take` in SI units, checked as by checkLog(). Returns the notes, which are complete only if
  /// all samples were read. Several threads may read at the same time. Throws LogError and whatever `take` throws.
  virtual std::vector<std::string> read(const Take& take) const = 0;
};

using LogSources = std::vector<std::shared_ptr<const LogSource>>;

/// Returns a source that refers to a log in memory. The log must outlive the source.
std::shared_ptr<const LogSource> sourceOf(const Log& log);

/// Returns a source that owns a log in memory.
std::shared_ptr<const LogSource> sourceOf(Log&& log);

/// Opens the log of a file. A file in text, HDF5 or RPC III with more than four blocks of kLogBlock samples is read
/// again by each call of read() and never kept in memory. Other files are read once and kept. Throws LogError.
std::shared_ptr<const LogSource> openLog(const std::string& path, const LogFormat& format = {});

/// Opens the log of a file. If the format requests all segments, all are opened and kept in memory. Throws LogError.
LogSources openLogs(const std::string& path, const LogFormat& format = {});

}  // namespace rubber_suspension::log
