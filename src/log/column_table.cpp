// A log from a file of whole columns.
#include "log/column_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "log/log_columns.h"

namespace rubber_suspension::log {
namespace {

// Reads the columns of a log part by part.
class ColumnReader {
 public:
  ColumnReader(const std::vector<ColumnName>& names, const ColumnFile& file, const LogFormat& format)
      : file_(file), format_(format), columns_(findColumns(names, format)) {
    notes_ = notesOnIgnored(names, columns_, format);
    samples_ = lengthOf(columns_.displacement);
    for (const Column* column : {&columns_.time, &columns_.force, &columns_.temperature}) {
      requireLength(*column);
    }
    if (samples_ < 2) {
      throw std::runtime_error(
          fmt::format("{}: {} samples; accepted: at least 2", columns_.displacement.name, samples_));
    }
  }

  std::size_t samples() const { return samples_; }

  void read(std::size_t first, std::size_t count, Log& block) {
    block.displacement = readConverted(columns_.displacement, first, count);
    block.force = readConverted(columns_.force, first, count);
    block.temperature = readConverted(columns_.temperature, first, count);
    readStamps(first, count, block.stamp);
    first_stamp_ = first == 0 ? block.stamp.front() : first_stamp_;
    last_stamp_ = block.stamp.back();
  }

  /// Once all is read.
  std::vector<std::string> notes() const {
    std::vector<std::string> notes = notes_;
    if (!areCanonical(columns_)) {
      notes.insert(notes.begin(), describeColumns(columns_, {samples_, first_stamp_, last_stamp_}));
    }
    return notes;
  }

 private:
  std::size_t lengthOf(const Column& column) const { return file_.length(column.index, column.name); }

  void requireLength(const Column& column) const {
    if (column.found() && lengthOf(column) != samples_) {
      throw std::runtime_error(fmt::format("{} has {} values, {} has {}; accepted: as many in each column", column.name,
                                           lengthOf(column), columns_.displacement.name, samples_));
    }
  }

  std::vector<double> readFinite(const Column& column, std::size_t first, std::size_t count) const {
    std::vector<double> values = file_.read(column.index, column.name, first, count);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i])) {
        throw std::runtime_error(fmt::format("{}: element {}: {} is not finite; accepted: a finite number", column.name,
                                             first + i + 1, values[i]));
      }
    }
    return values;
  }

  std::vector<double> readConverted(const Column& column, std::size_t first, std::size_t count) const {
    std::vector<double> values = column.found() ? readFinite(column, first, count) : std::vector<double>();
    std::transform(values.begin(), values.end(), values.begin(), column.conversion);
    return values;
  }

  void readStamps(std::size_t first, std::size_t count, std::vector<std::int64_t>& stamps) const {
    stamps.clear();
    stamps.reserve(count);
    if (format_.rate) {
      for (std::size_t i = first; i < first + count; ++i) {
        stamps.push_back(stampAtRate(i, *format_.rate));
      }
      return;
    }
    const std::vector<double> times = readFinite(columns_.time, first, count);
    std::int64_t last = last_stamp_;
    for (std::size_t i = 0; i < times.size(); ++i) {
      try {
        const std::int64_t stamp = toStamp(times[i], columns_.time);
        if (first + i > 0) {
          requireIncrease(last, stamp, columns_.time);
        }
        stamps.push_back(stamp);
        last = stamp;
      } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("element {}: {}", first + i + 1, error.what()));
      }
    }
  }

  const ColumnFile& file_;
  const LogFormat& format_;
  Columns columns_;
  std::vector<std::string> notes_;
  std::size_t samples_ = 0;
  std::int64_t first_stamp_ = 0;
  std::int64_t last_stamp_ = 0;
};

}  // namespace

std::vector<std::string> blocksFromColumns(const std::vector<ColumnName>& names, const ColumnFile& file,
                                           const LogFormat& format, const std::string& name, std::size_t block,
                                           const LogSource::Take& take) {
  ColumnReader reader(names, file, format);
  Log samples;
  samples.name = name;
  bool more = true;
  for (std::size_t first = 0; more && first < reader.samples(); first += samples.size()) {
    reader.read(first, std::min(block, reader.samples() - first), samples);
    more = take(samples, first);
  }
  return reader.notes();
}

Log logFromColumns(const std::vector<ColumnName>& names, const ColumnFile& file, const LogFormat& format,
                   const std::string& name) {
  ColumnReader reader(names, file, format);
  Log log;
  log.name = name;
  reader.read(0, reader.samples(), log);
  log.notes = reader.notes();
  return log;
}

}  // namespace rubber_suspension::log
