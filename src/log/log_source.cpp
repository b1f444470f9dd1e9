// Logs that are read block by block.
#include "rubber_suspension/log/log_source.h"

#include <algorithm>
#include <utility>

#include "log/file_format.h"
#include "log/file_readers.h"
#include "log/log_columns.h"
#include "log/samples.h"

namespace rubber_suspension::log {
namespace {

constexpr std::size_t kMostKept = 4 * kLogBlock;  // samples; shorter logs are kept in memory, which is faster

class MemorySource : public LogSource {
 public:
  explicit MemorySource(std::shared_ptr<const Log> log) : log_(std::move(log)) {}

  std::string name() const override { return log_->name; }

  std::vector<std::string> read(const Take& take) const override {
    const Log& log = *log_;
    checkLengths(log);
    checkSamples(log, 0, log.size());
    std::size_t first = 0;
    handOutBlocks(log, kLogBlock, take, first);
    return log.notes;
  }

 private:
  std::shared_ptr<const Log> log_;
};

using ReadBlocks = std::vector<std::string> (*)(const std::string& path, const LogFormat& format,
                                                const LogSource::Take& take);

// A log that is read from its file again by each call of read().
class LogFileSource : public LogSource {
 public:
  LogFileSource(std::string path, LogFormat format, ReadBlocks read_blocks)
      : path_(std::move(path)), format_(std::move(format)), read_(read_blocks) {}

  std::string name() const override {
    return format_.segment == 0 ? logName(path_) : segmentName(logName(path_), format_.segment);
  }
  std::vector<std::string> read(const Take& take) const override { return read_(path_, format_, take); }

 private:
  std::string path_;
  LogFormat format_;
  ReadBlocks read_;
};

}  // namespace

std::shared_ptr<const LogSource> sourceOf(const Log& log) {
  return std::make_shared<MemorySource>(std::shared_ptr<const Log>(std::shared_ptr<void>(), &log));  // not owned
}

std::shared_ptr<const LogSource> sourceOf(Log&& log) {
  return std::make_shared<MemorySource>(std::make_shared<Log>(std::move(log)));
}

std::shared_ptr<const LogSource> openLog(const std::string& path, const LogFormat& format) {
  const FileFormat kind = formatOfFile(path);
  if (kind == FileFormat::matlab || kind == FileFormat::bag || !isRegularFile(path)) {
    return sourceOf(readLog(path, format));
  }
  const ReadBlocks read_blocks = kind == FileFormat::hdf5  ? readHdf5Blocks
                                 : kind == FileFormat::rpc ? readRpcBlocks
                                                           : readCsvBlocks;
  auto file = std::make_shared<LogFileSource>(path, format, read_blocks);
  Log kept;
  bool all = true;
  std::vector<std::string> notes = file->read([&](const Log& block, std::size_t first) {
    all = first + block.size() <= kMostKept;
    if (all) {
      appendSamples(block, 0, block.size(), kept);
    }
    return all;
  });
  if (!all) {
    return file;
  }
  kept.name = file->name();
  kept.notes = std::move(notes);
  return sourceOf(std::move(kept));
}

std::vector<Log> readLogs(const std::string& path, const LogFormat& format) {
  switch (formatOfFile(path)) {
    case FileFormat::matlab:
      return readMatLogs(path, format);
    case FileFormat::hdf5:
      return readHdf5Logs(path, format);
    case FileFormat::rpc:
      return readRpcLogs(path, format);
    default:
      return readCsvLogs(path, format);
  }
}

Log readLog(const std::string& path, const LogFormat& format) { return onlyLog(path, readLogs(path, format)); }

LogSources openLogs(const std::string& path, const LogFormat& format) {
  if (format.segment != kAllSegments) {
    return {openLog(path, format)};
  }
  LogSources sources;
  for (Log& log : readLogs(path, format)) {
    sources.push_back(sourceOf(std::move(log)));
  }
  return sources;
}

}  // namespace rubber_suspension::log
