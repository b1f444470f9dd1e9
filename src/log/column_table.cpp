// Makes a log from a file of whole columns.
#include "log/column_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "element/refuse.h"
#include "log/file_readers.h"
#include "log/log_columns.h"
#include "log/sample_rules.h"
#include "log/samples.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

// The columns of one log.
struct ColumnSegment {
  std::string name;
  std::vector<ColumnName> names;
  std::vector<std::string> groups;
  std::vector<std::size_t> places;
};

// Reads, part by part, columns that share one column of time.
class Cursor {
 public:
  Cursor(const ColumnFile& file, const std::vector<std::size_t>& places, const Column& time, std::size_t length)
      : file_(file), places_(places), time_(time), length_(length) {}

  void add(const Column& column, std::size_t signal) { columns_.push_back({&column, signal, {}}); }

  const Column& time() const { return time_; }
  std::size_t length() const { return length_; }
  bool atEnd() const { return next_ == length_; }

  /// Reads the next part, of at most `part` elements, once all elements of the present part are used.
  void load(std::size_t part) {
    if (atEnd() || next_ < end_) {
      return;
    }
    begin_ = next_;
    end_ = next_ + std::min(part, length_ - next_);
    times_ = timesOf();
    for (Read& read : columns_) {
      read.numbers = numbersOf(*read.column);
    }
  }

  /// Returns the stamp of the next element; nullopt if the element has no finite time. Throws RowError.
  std::optional<std::int64_t> stamp(std::string& reason) const {
    if (times_.empty() || !isNumber(times_[next_ - begin_], time_, reason)) {
      return std::nullopt;
    }
    try {
      return toStamp(times_[next_ - begin_], time_);
    } catch (const std::runtime_error& error) {
      throw RowError(next_ + 1, error.what());
    }
  }

  /// Adds the values of the next element to a row and advances to the element after it.
  void take(SampleRow& row) {
    row.place = next_ + 1;
    for (const Read& read : columns_) {
      const double number = read.numbers[next_ - begin_];
      const bool measured = isNumber(number, *read.column, row.unmeasured[read.signal + 1]);
      row.value[read.signal] = measured ? number : kNotMeasured;
      row.faulty[read.signal] = std::isinf(number);
    }
    ++next_;
  }

 private:
  struct Read {
    const Column* column;
    std::size_t signal;
    std::vector<double> numbers;
  };

  std::vector<double> numbersOf(const Column& column) const {
    return file_.read(places_[column.index], column.name, begin_, end_ - begin_);
  }

  std::vector<long double> timesOf() const {
    if (time_.found() && file_.read_time) {
      return file_.read_time(places_[time_.index], time_.name, begin_, end_ - begin_);
    }
    const std::vector<double> times = time_.found() ? numbersOf(time_) : std::vector<double>();
    return {times.begin(), times.end()};
  }

  template <class Number>
  static bool isNumber(Number number, const Column& column, std::string& reason) {
    if (!std::isfinite(number)) {
      reason = fmt::format("{}: {} is not finite", column.name, number);
    }
    return std::isfinite(number);
  }

  const ColumnFile& file_;
  const std::vector<std::size_t>& places_;
  Column time_;
  std::size_t length_;
  std::vector<Read> columns_;
  std::vector<long double> times_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t next_ = 0;
};

// Reads the columns of a log part by part. A group of columns with a time of its own uses that time.
class ColumnReader {
 public:
  ColumnReader(const ColumnSegment& segment, const ColumnTable& table, const LogFormat& format)
      : segment_(segment),
        table_(table),
        format_(format),
        columns_(findColumns(segment.names, format)),
        units_(unitsOf(columns_, format)),
        rules_(format, columns_, table.place) {
    requireTimeUnit(columns_, format);
    cursors_.emplace_back(table.file, segment.places, columns_.time, lengthOf(columns_.displacement));
    requireLength(columns_.time);
    cursors_.front().add(columns_.displacement, kMotion);
    addSignal(columns_.force, kForce);
    addSignal(columns_.temperature, kTemperature);
    element::refuseIf<std::runtime_error>(samples() < 2, "{}: {} samples; accepted: at least 2",
                                          columns_.displacement.name, samples());
    std::vector<ColumnName> others = segment.names;
    for (std::size_t i = 1; i < cursors_.size(); ++i) {
      others[cursors_[i].time().index].text.clear();
    }
    notes_ = notesOnIgnored(others, columns_, format);
  }
  ColumnReader(const ColumnReader&) = delete;
  ColumnReader& operator=(const ColumnReader&) = delete;

  std::size_t samples() const { return cursors_.front().length(); }

  /// Passes the log to `take` in blocks of at least `part` samples until `take` returns false.
  void read(std::size_t part, const std::function<bool(Log& block)>& take) {
    Log block;
    try {
      bool more = true;
      while (more && readRow(part, block)) {
        if (block.size() >= part) {
          more = handOut(block, take);
        }
      }
      if (more) {
        rules_.finish(block);
        handOut(block, take);
      }
    } catch (const RowError& error) {
      throw std::runtime_error(fmt::format("{} {}: {}", table_.place, error.row(), error.what()));
    }
  }

  /// Returns the notes, which are complete once all samples are read.
  std::vector<std::string> notes() const {
    std::vector<std::string> notes = notes_;
    if (!table_.is_own && !areCanonical(columns_)) {
      notes.insert(notes.begin(), describeColumns(columns_, rules_.extent()));
    }
    const std::vector<std::string> of_rows = rules_.notes();
    notes.insert(notes.end(), of_rows.begin(), of_rows.end());
    return notes;
  }

 private:
  std::size_t lengthOf(const Column& column) const {
    return table_.file.length(segment_.places[column.index], column.name);
  }

  void addSignal(const Column& column, std::size_t signal) {
    if (!column.found()) {
      return;
    }
    const Column own_time = timeBeside(column);
    if (own_time.found()) {
      cursors_.emplace_back(table_.file, segment_.places, own_time, lengthOf(column));
    } else {
      requireLength(column);
    }
    (own_time.found() ? cursors_.back() : cursors_.front()).add(column, signal);
  }

  // Returns the time column in the group of a column; none if the time of the displacement applies to the group.
  Column timeBeside(const Column& column) const {
    const std::string& group = segment_.groups[column.index];
    if (format_.rate || !columns_.time.found() || group == segment_.groups[columns_.displacement.index]) {
      return {};
    }
    const std::string leaf = leafOf(columns_.time.name);
    for (std::size_t i = 0; i < segment_.names.size(); ++i) {
      const ColumnName& name = segment_.names[i];
      const bool is_time = leafOf(name.text) == leaf || quantityOfName(name.bare) == Quantity::time;
      if (segment_.groups[i] == group && i != columns_.time.index && is_time) {
        Column time = timeAt(segment_.names, i, format_);
        time.conversion = time.tells_unit ? time.conversion : columns_.time.conversion;
        return lengthOf(time) == lengthOf(column) ? time : Column();
      }
    }
    return {};
  }

  static std::string leafOf(const std::string& name) { return name.substr(name.find_last_of("/.") + 1); }

  void requireLength(const Column& column) const {
    if (column.found() && lengthOf(column) != samples()) {
      throw std::runtime_error(
          fmt::format("{} has {} values, {} has {}; accepted: equal numbers, or a separate time in the group",
                      column.name, lengthOf(column), columns_.displacement.name, samples()));
    }
  }

  // Adds the next row by merging all cursors in the order of their stamps. Returns false at the end of the columns.
  bool readRow(std::size_t part, Log& block) {
    SampleRow row;
    std::optional<std::int64_t> first;
    for (Cursor& cursor : cursors_) {
      cursor.load(part);
      if (cursor.atEnd()) {
        continue;
      }
      const auto stamp = cursor.stamp(row.unmeasured[0]);
      if (!stamp) {  // a row without a time
        cursor.take(row);
        rules_.take(row, block);
        return true;
      }
      first = std::min(first.value_or(*stamp), *stamp);
    }
    if (!first) {
      return false;
    }
    row.stamp = first;
    std::string reason;
    for (Cursor& cursor : cursors_) {
      if (!cursor.atEnd() && cursor.stamp(reason) == first) {
        const std::size_t place = row.place;
        cursor.take(row);
        row.place = place == 0 ? row.place : place;
      }
    }
    rules_.take(row, block);
    return true;
  }

  bool handOut(Log& block, const std::function<bool(Log& block)>& take) const {
    block.units = units_;
    const bool more = block.size() == 0 || take(block);
    block = Log();
    return more;
  }

  const ColumnSegment& segment_;
  const ColumnTable& table_;
  LogFormat format_;
  Columns columns_;
  UnitsAre units_;
  SampleRules rules_;
  std::vector<Cursor> cursors_;  // the first cursor is that of the displacement
  std::vector<std::string> notes_;
};

ColumnSegment segmentWhere(const ColumnTable& table, const std::string& group) {
  ColumnSegment segment{group, {}, {}, {}};
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (table.groups[i] == group) {
      segment.names.push_back(table.names[i]);
      segment.groups.push_back(group);
      segment.places.push_back(i);
    }
  }
  return segment;
}

// Returns a segment for each group that contains a log if there are several; otherwise one segment of all columns.
std::vector<ColumnSegment> segmentsOf(const ColumnTable& table, const LogFormat& format) {
  std::vector<ColumnSegment> segments;
  std::set<std::string> seen;
  for (const std::string& group : table.groups) {
    if (seen.insert(group).second) {
      ColumnSegment segment = segmentWhere(table, group);
      if (holdsLog(segment.names, format)) {
        segments.push_back(std::move(segment));
      }
    }
  }
  if (segments.size() < 2) {
    std::vector<std::size_t> all(table.names.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    segments = {{"", table.names, table.groups, all}};
  }
  return segments;
}

std::vector<ColumnSegment> wantedSegments(const ColumnTable& table, const LogFormat& format, const std::string& name) {
  std::vector<ColumnSegment> segments = segmentsOf(table, format);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    words.push_back(quoted(segments[i].name));
    segments[i].name = segments.size() == 1 ? name : segmentName(name, i + 1);
  }
  const auto chosen = chosenSegment(format, words);
  return chosen ? std::vector<ColumnSegment>{segments[*chosen]} : segments;
}

}  // namespace

std::vector<std::string> blocksFromColumns(const ColumnTable& table, const LogFormat& format, const std::string& name,
                                           std::size_t block, const LogSource::Take& take) {
  const ColumnSegment segment = wantedSegments(table, format, name).front();
  ColumnReader reader(segment, table, format);
  std::size_t handed_out = 0;
  reader.read(block, [&](Log& samples) {
    samples.name = segment.name;
    return handOutBlocks(samples, block, take, handed_out);
  });
  return reader.notes();
}

std::vector<Log> logsFromColumns(const ColumnTable& table, const LogFormat& format, const std::string& name) {
  std::vector<Log> logs;
  for (const ColumnSegment& segment : wantedSegments(table, format, name)) {
    ColumnReader reader(segment, table, format);
    logs.emplace_back();
    reader.read(kMaximumLogRows, [&](Log& log) {
      logs.back() = std::move(log);
      return true;
    });
    logs.back().name = segment.name;
    logs.back().notes = reader.notes();
  }
  return logs;
}

}  // namespace rubber_suspension::log
