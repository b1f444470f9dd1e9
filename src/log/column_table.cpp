// A log from a file of whole columns.
#include "log/column_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "element/refuse.h"
#include "log/file_readers.h"
#include "log/log_columns.h"
#include "log/sample_rules.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

// Reads the columns of a log part by part.
class ColumnReader {
 public:
  ColumnReader(const std::vector<ColumnName>& names, const std::vector<std::size_t>& places, const ColumnFile& file,
               const LogFormat& format)
      : places_(places),
        file_(file),
        names_(names),
        columns_(findColumns(names, format)),
        units_(unitsOf(columns_, format)),
        rules_(format, columns_, "element") {
    requireTimeUnit(columns_, format);
    notes_ = notesOnIgnored(names, columns_, format);
    samples_ = lengthOf(columns_.displacement);
    for (const Column* column : columns_.all()) {
      requireLength(*column);
    }
    element::refuseIf<std::runtime_error>(samples_ < 2, "{}: {} samples; accepted: at least 2",
                                          columns_.displacement.name, samples_);
  }
  ColumnReader(const ColumnReader&) = delete;
  ColumnReader& operator=(const ColumnReader&) = delete;

  std::size_t samples() const { return samples_; }

  void read(std::size_t first, std::size_t count, Log& block) {
    block.units = units_;
    const std::vector<long double> time = times(first, count);
    const std::vector<double> displacement = numbers(columns_.displacement, first, count);
    const std::vector<double> force = numbers(columns_.force, first, count);
    const std::vector<double> temperature = numbers(columns_.temperature, first, count);
    try {
      for (std::size_t i = 0; i < count; ++i) {
        SampleRow row;
        row.place = first + i + 1;
        row.displacement = valueOf(columns_.displacement, displacement, i, row);
        row.force = valueOf(columns_.force, force, i, row);
        row.temperature = valueOf(columns_.temperature, temperature, i, row);
        setStamp(time, i, row);
        rules_.take(row, block);
      }
      if (first + count == samples_) {
        rules_.finish();
      }
    } catch (const RowError& error) {
      throw std::runtime_error(fmt::format("element {}: {}", error.row(), error.what()));
    }
  }

  /// Once all is read.
  std::vector<std::string> notes() const {
    std::vector<std::string> notes = notes_;
    if (!areCanonical(columns_)) {
      notes.insert(notes.begin(), describeColumns(columns_, rules_.extent()));
    }
    const std::vector<std::string> of_rows = rules_.notes();
    notes.insert(notes.end(), of_rows.begin(), of_rows.end());
    return notes;
  }

 private:
  std::size_t lengthOf(const Column& column) const { return file_.length(places_[column.index], column.name); }

  void requireLength(const Column& column) const {
    if (column.found() && lengthOf(column) != samples_) {
      throw std::runtime_error(fmt::format("{} has {} values, {} has {}; accepted: as many in each column{}",
                                           column.name, lengthOf(column), columns_.displacement.name, samples_,
                                           conversion()));
    }
  }

  // The line that brings force and displacement of two groups, each with a time of its own, to one rate.
  std::string conversion() const {
    const std::string group = groupOf(columns_.force.name);
    const auto time = std::find_if(names_.begin(), names_.end(), [&](const ColumnName& name) {
      return groupOf(name.text) == group && quantityOfName(name.bare) == Quantity::time;
    });
    if (file_.path.empty() || !columns_.force.found() || !columns_.time.found() || time == names_.end()) {
      return "";
    }
    return fmt::format(
        ", by python3 -c \"import h5py, numpy as n; f = h5py.File('{}'); t = f['{}'][:]; n.savetxt('LOG.csv', n.c_[t, "
        "n.interp(t, f['{}'], f['{}']), f['{}']], delimiter=',', header='time_s,displacement_{},force_{}', "
        "comments='')\"",
        file_.path, time->text, columns_.time.name, columns_.displacement.name, columns_.force.name,
        names_[columns_.displacement.index].unit, names_[columns_.force.index].unit);
  }

  std::vector<double> numbers(const Column& column, std::size_t first, std::size_t count) const {
    return column.found() ? file_.read(places_[column.index], column.name, first, count) : std::vector<double>();
  }

  std::vector<long double> times(std::size_t first, std::size_t count) const {
    if (columns_.time.found() && file_.read_time) {
      return file_.read_time(places_[columns_.time.index], columns_.time.name, first, count);
    }
    const std::vector<double> time = numbers(columns_.time, first, count);
    return {time.begin(), time.end()};
  }

  template <class Number>
  static double valueOf(const Column& column, const std::vector<Number>& numbers, std::size_t i, SampleRow& row) {
    if (!column.found()) {
      return 0.0;
    }
    if (!std::isfinite(numbers[i])) {
      row.unmeasured = fmt::format("{}: {} is not finite", column.name, numbers[i]);
      return std::numeric_limits<double>::quiet_NaN();
    }
    return column.toSi(static_cast<double>(numbers[i]));
  }

  void setStamp(const std::vector<long double>& time, std::size_t i, SampleRow& row) const {
    const double value = time.empty() ? 0.0 : valueOf(columns_.time, time, i, row);
    if (!time.empty() && std::isfinite(value)) {
      try {
        row.stamp = toStamp(time[i], columns_.time);
      } catch (const std::runtime_error& error) {
        throw RowError(row.place, error.what());
      }
    }
  }

  std::vector<std::size_t> places_;  // in the file, of the columns
  const ColumnFile& file_;
  const std::vector<ColumnName>& names_;
  Columns columns_;
  UnitsAre units_;
  SampleRules rules_;
  std::vector<std::string> notes_;
  std::size_t samples_ = 0;
};

// Columns that make one log.
struct ColumnSegment {
  std::string name;
  std::vector<ColumnName> names;
  std::vector<std::size_t> places;
};

ColumnSegment segmentWhere(const ColumnTable& table, const std::string& group) {
  ColumnSegment segment{group, {}, {}};
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (table.groups[i] == group) {
      segment.names.push_back(table.names[i]);
      segment.places.push_back(i);
    }
  }
  return segment;
}

// Each group that holds a log, where several do; otherwise all columns together.
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
    segments = {{"", table.names, all}};
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
  ColumnReader reader(segment.names, segment.places, table.file, format);
  bool more = true;
  std::size_t handed_out = 0;
  for (std::size_t first = 0; more && first < reader.samples(); first += block) {
    Log samples;
    samples.name = segment.name;
    reader.read(first, std::min(block, reader.samples() - first), samples);
    more = samples.size() == 0 || take(samples, handed_out);
    handed_out += samples.size();
  }
  return reader.notes();
}

std::vector<Log> logsFromColumns(const ColumnTable& table, const LogFormat& format, const std::string& name) {
  std::vector<Log> logs;
  for (const ColumnSegment& segment : wantedSegments(table, format, name)) {
    ColumnReader reader(segment.names, segment.places, table.file, format);
    Log log;
    log.name = segment.name;
    reader.read(0, reader.samples(), log);
    log.notes = reader.notes();
    logs.push_back(std::move(log));
  }
  return logs;
}

}  // namespace rubber_suspension::log
