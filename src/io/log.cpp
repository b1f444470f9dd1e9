// Logs: the rules of their columns, reading and writing as CSV, checks that hold for a log of any source.
#include "rubber_suspension/io/log.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>

#include "line_reader.h"
#include "rubber_suspension/io/units.h"
#include "text.h"

namespace rubber_suspension {
namespace {

// 285 years: stamps stay well within 64 bits of nanoseconds.
constexpr double kMaximumTime = 9.0e9;
constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);
const std::vector<std::string> kDisplacementUnits = {"m", "mm", "um"};
const std::vector<std::string> kForceUnits = {"N", "kN", "MN"};

// A column that is read: where it stands and what converts its numbers.
struct Column {
  std::size_t index = kNoColumn;
  std::string name;
  UnitConversion conversion{"1", "1"};

  bool found() const { return index != kNoColumn; }
};

struct Columns {
  std::size_t count = 0;  // of all columns in the header
  Column time;
  Column displacement;
  Column force;
  Column temperature;
};

std::string join(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

// The name in a field of the header, which some programs put into quotes.
std::string fieldName(const std::string& field) {
  const std::string name = trimmed(field);
  const bool quoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
  return quoted ? trimmed(name.substr(1, name.size() - 2)) : name;
}

std::vector<std::string> splitHeader(const std::string& line) {
  std::vector<std::string> names;
  std::size_t start = 0;
  for (std::size_t comma = 0; comma != std::string::npos; start = comma + 1) {
    comma = line.find(',', start);
    names.push_back(fieldName(line.substr(start, comma == std::string::npos ? comma : comma - start)));
  }
  return names;
}

void refuseOtherEncodings(const std::string& header) {
  if (header.compare(0, 2, "\xFF\xFE") == 0 || header.compare(0, 2, "\xFE\xFF") == 0) {
    throw std::runtime_error("text in UTF-16; accepted: UTF-8");
  }
  for (const auto& [separator, name] : {std::pair<char, const char*>{';', "';'"}, {'\t', "tab"}}) {
    if (header.find(',') == std::string::npos && header.find(separator) != std::string::npos) {
      throw std::runtime_error(fmt::format("separator {} in the header; accepted: ','", name));
    }
  }
}

std::size_t findName(const std::vector<std::string>& header, const std::string& name) {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) {
    return kNoColumn;
  }
  if (std::find(found + 1, header.end(), name) != header.end()) {
    throw std::runtime_error(fmt::format("column '{}' stands twice in the header", name));
  }
  return static_cast<std::size_t>(found - header.begin());
}

Column namedColumn(const std::vector<std::string>& header, const std::string& name) {
  Column column;
  column.index = findName(header, name);
  column.name = name;
  return column;
}

Column requireColumn(const std::vector<std::string>& header, const std::string& name) {
  Column column = namedColumn(header, name);
  if (!column.found()) {
    throw std::runtime_error(fmt::format("no column '{}'; the header has: {}", name, join(header)));
  }
  return column;
}

std::vector<std::string> namesWithUnits(const std::string& quantity, const std::vector<std::string>& units) {
  std::vector<std::string> names;
  for (const std::string& unit : units) {
    names.push_back(quantity + "_" + unit);
  }
  return names;
}

// The column quantity_<unit>; more than one is ambiguous, one without or with another unit is no such column.
Column columnWithUnit(const std::vector<std::string>& header, const std::string& quantity,
                      const std::vector<std::string>& units) {
  Column result;
  for (const std::string& unit : units) {
    Column column = namedColumn(header, quantity + "_" + unit);
    if (!column.found()) {
      continue;
    }
    if (result.found()) {
      throw std::runtime_error(
          fmt::format("columns '{}' and '{}' are both there; accepted: one of them", result.name, column.name));
    }
    column.conversion = UnitConversion(unit, units.front());
    result = column;
  }
  const auto alike = std::find_if(header.begin(), header.end(), [&](const std::string& name) {
    return name == quantity || name.compare(0, quantity.size() + 1, quantity + "_") == 0;
  });
  if (!result.found() && alike != header.end()) {
    throw std::runtime_error(
        fmt::format("column '{}' has no accepted unit; accepted: {}", *alike, join(namesWithUnits(quantity, units))));
  }
  return result;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

Column mappedColumn(const std::vector<std::string>& header, const std::string& name, const std::string& unit,
                    const std::vector<std::string>& units) {
  Column column = requireColumn(header, name);
  std::string used = unit;
  for (const std::string& candidate : units) {
    used = used.empty() && endsWith(name, "_" + candidate) ? candidate : used;
  }
  column.conversion = UnitConversion(used.empty() ? units.front() : used, units.front());
  return column;
}

Columns findColumns(const std::vector<std::string>& header, const LogFormat& format) {
  Columns columns;
  columns.count = header.size();
  if (!format.rate) {
    columns.time = requireColumn(header, format.time_column.empty() ? "time_s" : format.time_column);
  }
  columns.displacement =
      format.displacement_column.empty()
          ? columnWithUnit(header, "displacement", kDisplacementUnits)
          : mappedColumn(header, format.displacement_column, format.displacement_unit, kDisplacementUnits);
  if (!columns.displacement.found()) {
    throw std::runtime_error(fmt::format("no column of displacement; accepted: {}; the header has: {}",
                                         join(namesWithUnits("displacement", kDisplacementUnits)), join(header)));
  }
  columns.force = format.force_column.empty()
                      ? columnWithUnit(header, "force", kForceUnits)
                      : mappedColumn(header, format.force_column, format.force_unit, kForceUnits);
  columns.temperature = format.temperature_column.empty() ? namedColumn(header, "temperature_degC")
                                                          : requireColumn(header, format.temperature_column);
  return columns;
}

std::vector<std::string> notesOnIgnored(const std::vector<std::string>& header, const Columns& columns) {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const bool read = i == columns.time.index || i == columns.displacement.index || i == columns.force.index ||
                      i == columns.temperature.index;
    if (!read) {
      notes.push_back(fmt::format("column '{}' is ignored", header[i]));
    }
  }
  return notes;
}

// Decimal notation only: strtod would take hexadecimal numbers as well.
void requireDecimal(const char* field, const char* field_end, const Column& column) {
  const std::size_t length = static_cast<std::size_t>(field_end - field);
  for (const char* c = field; c != field_end; ++c) {
    if (*c == 'x' || *c == 'X') {
      throw std::runtime_error(
          fmt::format("{}: '{}' is not a number; accepted: decimal notation", column.name, std::string(field, length)));
    }
  }
}

template <class Number>
void requireNumber(Number value, const char* field, const char* parsed_end, const char* field_end,
                   const Column& column) {
  while (*parsed_end == ' ' || *parsed_end == '\t') {
    ++parsed_end;
  }
  const std::string text = trimmed(std::string(field, static_cast<std::size_t>(field_end - field)));
  if (text.empty()) {
    throw std::runtime_error(fmt::format("{}: empty field; accepted: a finite number", column.name));
  }
  if (parsed_end != field_end) {
    throw std::runtime_error(fmt::format("{}: '{}' is not a number", column.name, text));
  }
  if (!std::isfinite(value)) {
    throw std::runtime_error(fmt::format("{}: '{}' is not finite", column.name, text));
  }
}

double readNumber(const char* field, const char* field_end, const Column& column) {
  char* parsed_end = nullptr;
  const double value = strtod_l(field, &parsed_end, cLocale());
  requireDecimal(field, field_end, column);
  if (parsed_end != field_end || parsed_end == field || !std::isfinite(value)) {
    requireNumber(value, field, parsed_end, field_end, column);
  }
  return column.conversion(value);
}

// Long double keeps the nanoseconds of a time since 1970, which a double cannot hold.
std::int64_t readStamp(const char* field, const char* field_end, const Column& column) {
  char* parsed_end = nullptr;
  const long double value = strtold_l(field, &parsed_end, cLocale());
  requireDecimal(field, field_end, column);
  requireNumber(value, field, parsed_end, field_end, column);
  if (std::abs(value) > kMaximumTime) {
    throw std::runtime_error(fmt::format("{}: {:g} s is out of range; accepted: at most {:g} s", column.name,
                                         static_cast<double>(value), kMaximumTime));
  }
  return std::llroundl(value * 1e9L);
}

std::string formatStamp(std::int64_t stamp) {
  const std::int64_t magnitude = std::abs(stamp);
  return fmt::format("{}{}.{:09d}", stamp < 0 ? "-" : "", magnitude / 1000000000, magnitude % 1000000000);
}

// Where each field of a row begins; one more than there are fields, so that the end of field i is begin of i+1 less
// one.
void splitRow(const char* line, std::vector<const char*>& starts) {
  starts.clear();
  starts.push_back(line);
  const char* c = line;
  for (; *c != '\0'; ++c) {
    if (*c == ',') {
      starts.push_back(c + 1);
    }
  }
  starts.push_back(c + 1);
}

class CsvLogReader {
 public:
  CsvLogReader(const std::string& path, const LogFormat& format) : reader_(path, kMaximumLogLine), format_(format) {}

  Log read() {
    readHeader();
    while (const char* line = reader_.next()) {
      readRow(line);
    }
    if (log_.size() < 2) {
      throw std::runtime_error(
          fmt::format("{} sample{}; accepted: at least 2", log_.size(), log_.size() == 1 ? "" : "s"));
    }
    if (!reader_.lastLineEnded()) {
      log_.notes.push_back(fmt::format("line {}, the last, has no line end: it may have been cut off", reader_.line()));
    }
    return std::move(log_);
  }

  std::size_t line() const { return std::max<std::size_t>(reader_.line(), 1); }

 private:
  void readHeader() {
    const char* line = reader_.next();
    std::string header = line == nullptr ? "" : line;
    if (header.compare(0, 3, "\xEF\xBB\xBF") == 0) {
      header.erase(0, 3);
    }
    if (trimmed(header).empty()) {
      throw std::runtime_error(line == nullptr ? "the file is empty; accepted: a header and at least 2 rows"
                                               : "the header is blank; accepted: time_s,displacement_<unit>,...");
    }
    refuseOtherEncodings(header);
    const std::vector<std::string> names = splitHeader(header);
    columns_ = findColumns(names, format_);
    log_.notes = notesOnIgnored(names, columns_);
  }

  void readRow(const char* line) {
    if (line[std::strspn(line, " \t")] == '\0') {
      blank_line_ = blank_line_ == 0 ? reader_.line() : blank_line_;
      return;
    }
    if (blank_line_ != 0) {
      throw std::runtime_error(
          fmt::format("a row after blank line {}; accepted: no blank line between rows", blank_line_));
    }
    splitRow(line, starts_);
    if (starts_.size() - 1 != columns_.count) {
      throw std::runtime_error(fmt::format("{} field{}; accepted: {}, as in the header", starts_.size() - 1,
                                           starts_.size() == 2 ? "" : "s", columns_.count));
    }
    if (log_.size() == kMaximumLogRows) {
      throw std::runtime_error(fmt::format("more than {} rows; accepted: that many at most", kMaximumLogRows));
    }
    appendStamp();
    append(columns_.displacement, log_.displacement);
    append(columns_.force, log_.force);
    append(columns_.temperature, log_.temperature);
  }

  const char* fieldEnd(const Column& column) const { return starts_[column.index + 1] - 1; }

  void append(const Column& column, std::vector<double>& values) {
    if (column.found()) {
      values.push_back(readNumber(starts_[column.index], fieldEnd(column), column));
    }
  }

  void appendStamp() {
    if (format_.rate) {
      log_.stamp.push_back(std::llround(static_cast<double>(log_.size()) * 1e9 / *format_.rate));
      return;
    }
    const std::int64_t stamp = readStamp(starts_[columns_.time.index], fieldEnd(columns_.time), columns_.time);
    if (!log_.stamp.empty() && stamp <= log_.stamp.back()) {
      throw std::runtime_error(
          fmt::format("{}: {} after {}; accepted: time that increases from row to row, by 1 ns at least",
                      columns_.time.name, formatStamp(stamp), formatStamp(log_.stamp.back())));
    }
    log_.stamp.push_back(stamp);
  }

  LineReader reader_;
  LogFormat format_;
  Columns columns_;
  Log log_;
  std::size_t blank_line_ = 0;
  std::vector<const char*> starts_;
};

std::string baseName(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  return file.substr(0, file.find_last_of('.'));
}

void checkValues(const Log& log, const char* name, const std::vector<double>& values, bool may_be_missing) {
  if (values.empty() && may_be_missing) {
    return;
  }
  if (values.size() != log.size()) {
    throw LogError(
        fmt::format("{}: {} has {} values; accepted: {}, one per stamp", log.name, name, values.size(), log.size()));
  }
  const auto bad = std::find_if_not(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (bad != values.end()) {
    throw LogError(fmt::format("{}: sample {}: {} {} is not finite", log.name, bad - values.begin() + 1, name, *bad));
  }
}

void setColumn(LogFormat& format, const std::string& entry) {
  const std::size_t equals = entry.find('=');
  const std::string quantity = entry.substr(0, equals);
  const std::string column = equals == std::string::npos ? "" : entry.substr(equals + 1);
  const std::array<std::pair<const char*, std::string*>, 4> accepted = {{{"time", &format.time_column},
                                                                         {"displacement", &format.displacement_column},
                                                                         {"force", &format.force_column},
                                                                         {"temperature", &format.temperature_column}}};
  const auto found =
      std::find_if(accepted.begin(), accepted.end(), [&](const auto& pair) { return quantity == pair.first; });
  if (found == accepted.end() || column.empty()) {
    throw std::invalid_argument(
        fmt::format("--columns: '{}'; accepted: time=NAME, displacement=NAME, force=NAME, temperature=NAME", entry));
  }
  *found->second = column;
}

void setUnits(LogFormat& format, const std::string& units) {
  const std::size_t comma = units.find(',');
  format.displacement_unit = units.substr(0, comma);
  format.force_unit = comma == std::string::npos ? "" : units.substr(comma + 1);
  try {
    UnitConversion(format.displacement_unit, "m");
    UnitConversion(format.force_unit.empty() ? "N" : format.force_unit, "N");
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("--unit: '{}': {}; accepted: units of displacement and force, as in mm,kN", units, error.what()));
  }
}

}  // namespace

LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate) {
  LogFormat format;
  for (const std::string& entry : columns) {
    setColumn(format, entry);
  }
  if (!units.empty()) {
    setUnits(format, units);
  }
  // Above 1 GHz two samples would share a nanosecond.
  if (!(rate >= 0.0 && rate <= 1e9)) {
    throw std::invalid_argument(fmt::format("--rate: {:g} Hz; accepted: greater than 0, at most 1e9", rate));
  }
  if (rate > 0.0) {
    format.rate = rate;
  }
  return format;
}

Log readCsvLog(const std::string& path, const LogFormat& format) {
  std::unique_ptr<CsvLogReader> reader;
  try {
    reader = std::make_unique<CsvLogReader>(path, format);
    Log log = reader->read();
    log.name = baseName(path);
    return log;
  } catch (const std::runtime_error& error) {
    throw LogError(reader ? fmt::format("{}:{}: {}", path, reader->line(), error.what())
                          : fmt::format("{}: {}", path, error.what()));
  }
}

void checkLog(const Log& log) {
  if (log.size() < 2) {
    throw LogError(fmt::format("{}: {} samples; accepted: at least 2", log.name, log.size()));
  }
  for (std::size_t i = 1; i < log.size(); ++i) {
    if (log.stamp[i] <= log.stamp[i - 1]) {
      throw LogError(fmt::format("{}: sample {}: time {} after {}; accepted: time that increases", log.name, i + 1,
                                 formatStamp(log.stamp[i]), formatStamp(log.stamp[i - 1])));
    }
  }
  checkValues(log, "displacement", log.displacement, false);
  checkValues(log, "force", log.force, true);
  checkValues(log, "temperature", log.temperature, true);
}

void writeForceCsv(const std::string& path, const Log& log, const std::vector<double>& force) {
  if (force.size() != log.size()) {
    throw LogError(fmt::format("{}: {} forces for {} samples", path, force.size(), log.size()));
  }
  std::ofstream file(path, std::ios::binary);
  fmt::memory_buffer rows;
  fmt::format_to(std::back_inserter(rows), "time_s,displacement_m,force_N\n");
  for (std::size_t i = 0; i < log.size(); ++i) {
    fmt::format_to(std::back_inserter(rows), "{},{:.17g},{:.17g}\n", formatStamp(log.stamp[i]), log.displacement[i],
                   force[i]);
  }
  file.write(rows.data(), static_cast<std::streamsize>(rows.size()));
  file.close();
  if (!file) {
    throw LogError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
  }
}

}  // namespace rubber_suspension
