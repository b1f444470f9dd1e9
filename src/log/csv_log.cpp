// Reads a log from CSV.
#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "log/line_reader.h"
#include "log/log_columns.h"
#include "log/text.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {
namespace {

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

void refuseOtherFormats(const std::string& header) {
  if (header.compare(0, 2, "\xFF\xFE") == 0 || header.compare(0, 2, "\xFE\xFF") == 0) {
    throw std::runtime_error("text in UTF-16; accepted: UTF-8");
  }
  if (header.find('\r') != std::string::npos) {
    throw std::runtime_error("lines end in CR alone; accepted: LF or CRLF");
  }
  for (const auto& [separator, name] : {std::pair<char, const char*>{';', "';'"}, {'\t', "tab"}}) {
    if (header.find(',') == std::string::npos && header.find(separator) != std::string::npos) {
      throw std::runtime_error(fmt::format("separator {} in the header; accepted: ','", name));
    }
  }
}

// Decimal notation only: strtod would take hexadecimal numbers as well.
void requireDecimal(const char* field, const char* field_end, const Column& column) {
  const std::size_t length = static_cast<std::size_t>(field_end - field);
  for (const char* c = field; c != field_end; ++c) {
    if (*c == 'x' || *c == 'X') {
      throw std::runtime_error(fmt::format("{}: {} is not a number; accepted: decimal notation", column.name,
                                           quoted(std::string(field, length))));
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
    throw std::runtime_error(
        fmt::format("{}: {} is not a number; accepted: a finite number", column.name, quoted(text)));
  }
  if (!std::isfinite(value)) {
    throw std::runtime_error(fmt::format("{}: {} is not finite; accepted: a finite number", column.name, quoted(text)));
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
  return toStamp(value, column);
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
    refuseOtherFormats(header);
    const std::vector<std::string> names = splitHeader(header);
    columns_ = findColumns(names, format_);
    log_.notes = notesOnIgnored(names, columns_, format_);
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
      log_.stamp.push_back(stampAtRate(log_.size(), *format_.rate));
      return;
    }
    const std::int64_t stamp = readStamp(starts_[columns_.time.index], fieldEnd(columns_.time), columns_.time);
    requireIncrease(log_.stamp, stamp, columns_.time);
    log_.stamp.push_back(stamp);
  }

  LineReader reader_;
  LogFormat format_;
  Columns columns_;
  Log log_;
  std::size_t blank_line_ = 0;
  std::vector<const char*> starts_;
};

}  // namespace

Log readCsvLog(const std::string& path, const LogFormat& format) {
  std::unique_ptr<CsvLogReader> reader;
  try {
    reader = std::make_unique<CsvLogReader>(path, format);
    Log log = reader->read();
    log.name = logName(path);
    return log;
  } catch (const std::runtime_error& error) {
    throw LogError(reader ? fmt::format("{}:{}: {}", path, reader->line(), error.what())
                          : fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace rubber_suspension::log
