// Reads a log from CSV.
#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "log/byte_source.h"
#include "log/csv_blocks.h"
#include "log/csv_dialect.h"
#include "log/line_reader.h"
#include "log/log_columns.h"
#include "log/text.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::log {
namespace {

// Decimal notation only: strtod would take hexadecimal numbers as well.
void requireDecimal(const char* field, const char* field_end, const Column& column) {
  const char* c = field + std::strspn(field, " \t");
  c += *c == '-' || *c == '+' ? 1 : 0;
  if (*c == '0' && (c[1] == 'x' || c[1] == 'X')) {
    throw std::runtime_error(fmt::format("{}: {} is not a number; accepted: decimal notation", column.name,
                                         quoted(std::string(field, static_cast<std::size_t>(field_end - field)))));
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

// Numbers of any dialect: what is neither a field between commas nor without quotes may have a decimal comma.
class FieldParser {
 public:
  /// The field with a decimal point, ended by a 0; valid until the next call.
  const char* normalised(const Field& field, Separator separator, std::size_t line, const Column& column) {
    if (field.text.size() >= sizeof buffer_) {
      throw std::runtime_error(fmt::format("{}: {} is not a number; accepted: a finite number", column.name,
                                           quoted(std::string(field.text))));
    }
    field.text.copy(buffer_, field.text.size());
    buffer_[field.text.size()] = '\0';
    end_ = buffer_ + field.text.size();
    char* const comma = std::strchr(buffer_, ',');
    const bool may_have_comma = separator != Separator::comma || field.quoted;
    if (comma != nullptr && may_have_comma) {
      require(',', line, field, column);
      *comma = '.';
    } else if (may_have_comma && std::strchr(buffer_, '.') != nullptr) {
      require('.', line, field, column);
    }
    return buffer_;
  }

  const char* end() const { return end_; }
  bool hasDecimalComma() const { return mark_ == ','; }

 private:
  // One mark throughout: "1.234" is another number where the others are like "0,5".
  void require(char mark, std::size_t line, const Field& field, const Column& column) {
    const bool both = field.text.find('.') != std::string_view::npos && field.text.find(',') != std::string_view::npos;
    if (both || (mark_ != '\0' && mark_ != mark)) {
      throw std::runtime_error(fmt::format(
          "{}: {} has {}; accepted: one decimal mark throughout, no separators of thousands", column.name,
          quoted(std::string(field.text)),
          both ? "point and comma"
               : fmt::format("a decimal {} and line {} has a decimal {}", nameOf(mark), first_line_, nameOf(mark_))));
    }
    if (mark_ == '\0') {
      mark_ = mark;
      first_line_ = line;
    }
  }

  static const char* nameOf(char mark) { return mark == ',' ? "comma" : "point"; }

  char buffer_[128] = {};
  const char* end_ = buffer_;
  char mark_ = '\0';
  std::size_t first_line_ = 0;
};

class CsvLogReader {
 public:
  CsvLogReader(const std::string& path, const LogFormat& format) : format_(format) {
    log_.name = logName(path);
    TextSource source = openText(path);
    coding_ = source.coding;
    reader_ = std::make_unique<LineReader>(std::move(source.bytes), kMaximumLogLine);
  }

  Log read() {
    readRows(nullptr);
    return std::move(log_);
  }

  std::vector<std::string> readBlocks(const LogSource::Take& take) {
    readRows(&take);
    if (log_.size() > 0 && !ended_) {
      handOut(take);
    }
    return std::move(log_.notes);
  }

  /// Of what an error is about.
  std::size_t line() const { return line_; }

 private:
  // All rows are kept where nobody takes them.
  void readRows(const LogSource::Take* take) {
    readHeader();
    for (line_ = reader_->line() + 1; !ended_; ++line_) {
      const char* const line = reader_->next();
      if (line == nullptr) {
        break;
      }
      readRow(line);
      if (take != nullptr && log_.size() == kLogBlock) {
        handOut(*take);
      }
    }
    line_ = std::max<std::size_t>(reader_->line(), 1);
    if (count() < 2) {
      throw std::runtime_error(fmt::format("{} sample{}; accepted: at least 2", count(), count() == 1 ? "" : "s"));
    }
    if (!ended_) {
      addNotes();
    }
  }

  void handOut(const LogSource::Take& take) {
    const std::size_t first = handed_out_;
    handed_out_ += log_.size();
    ended_ = !take(log_, first);
    log_.stamp.clear();
    for (auto* values : {&log_.displacement, &log_.force, &log_.temperature}) {
      values->clear();
    }
  }

  // Of the rows read so far.
  std::size_t count() const { return handed_out_ + log_.size(); }

  void readHeader() {
    HeaderFinder finder(format_);
    std::vector<TextLine> head;
    std::optional<CsvHeader> header;
    while (!header && head.size() < kMaximumHeadLines) {
      line_ = reader_->line() + 1;
      const char* line = reader_->next();
      if (line == nullptr) {
        break;
      }
      head.push_back({line_, line});
      header = finder.add(head.back());
    }
    line_ = 1;
    refuseEmpty(head);
    header_ = header ? *header : finder.finish();
    line_ = std::max<std::size_t>(header_.line, 1);
    columns_ = findColumns(header_.names, format_);
    log_.notes = notesOnIgnored(header_.names, columns_, format_);
    readRowsOf(head);
  }

  static void refuseEmpty(const std::vector<TextLine>& head) {
    if (head.empty()) {
      throw std::runtime_error("the file is empty; accepted: a header and at least 2 rows");
    }
    if (std::all_of(head.begin(), head.end(), [](const TextLine& line) { return trimmed(line.text).empty(); })) {
      throw std::runtime_error("the header is blank; accepted: time_s,displacement_<unit>,...");
    }
  }

  // The rows among the lines that were read to find the header.
  void readRowsOf(const std::vector<TextLine>& head) {
    for (const TextLine& line : head) {
      if (line.number >= header_.next_line) {
        line_ = line.number;
        const bool has_quotes = line.text.find('"') != std::string::npos;
        by_fields_ = by_fields_ || header_.separator != Separator::comma || has_quotes;
        readRow(line.text.c_str());
      }
    }
  }

  void readRow(const char* line) {
    const char* const text = line + std::strspn(line, " \t");
    if (*text == '\0') {
      blank_line_ = blank_line_ == 0 ? line_ : blank_line_;
      return;
    }
    if (std::strchr("#%!/", *text) != nullptr && isComment(text)) {
      noteComment();
      return;
    }
    if (blank_line_ != 0 && count() > 0) {
      throw std::runtime_error(
          fmt::format("a row after blank line {}; accepted: no blank line between rows", blank_line_));
    }
    blank_line_ = 0;
    if (log_.size() == kMaximumLogRows) {  // never where they are handed out
      throw std::runtime_error(fmt::format("more than {} rows; accepted: that many at most", kMaximumLogRows));
    }
    if (by_fields_ || !readPlainRow(line)) {
      readRowByFields(line);
    }
  }

  // Commas and nothing else: the fast path. False where the number of fields tells that there is more to it.
  bool readPlainRow(const char* line) {
    splitRow(line, starts_);
    if (starts_.size() - 1 != columns_.count) {
      return false;
    }
    appendPlainStamp();
    appendPlain(columns_.displacement, log_.displacement);
    appendPlain(columns_.force, log_.force);
    appendPlain(columns_.temperature, log_.temperature);
    return true;
  }

  const char* plainEnd(const Column& column) const { return starts_[column.index + 1] - 1; }

  void appendPlain(const Column& column, std::vector<double>& values) {
    if (column.found()) {
      values.push_back(readNumber(starts_[column.index], plainEnd(column), column));
    }
  }

  void appendPlainStamp() {
    if (format_.rate) {
      appendRateStamp();
    } else {
      appendStamp(readStamp(starts_[columns_.time.index], plainEnd(columns_.time), columns_.time));
    }
  }

  void appendRateStamp() { keepStamp(stampAtRate(count(), *format_.rate)); }

  void appendStamp(std::int64_t stamp) {
    if (count() > 0) {
      requireIncrease(last_stamp_, stamp, columns_.time);
    }
    keepStamp(stamp);
  }

  void keepStamp(std::int64_t stamp) {
    first_stamp_ = count() == 0 ? stamp : first_stamp_;
    last_stamp_ = stamp;
    log_.stamp.push_back(stamp);
  }

  void readRowByFields(const char* line) {
    splitFields(line, header_.separator, fields_);
    while (fields_.size() > columns_.count && fields_.back().text.empty() && !fields_.back().quoted) {
      fields_.pop_back();  // a separator at the end of the line
    }
    if (fields_.size() != columns_.count) {
      throw std::runtime_error(fmt::format("{} field{}; accepted: {}, as in the header", fields_.size(),
                                           fields_.size() == 1 ? "" : "s", columns_.count));
    }
    if (format_.rate) {
      appendRateStamp();
    } else {
      const char* const text = normalised(columns_.time);
      appendStamp(readStamp(text, parser_.end(), columns_.time));
    }
    append(columns_.displacement, log_.displacement);
    append(columns_.force, log_.force);
    append(columns_.temperature, log_.temperature);
  }

  const char* normalised(const Column& column) {
    return parser_.normalised(fields_[column.index], header_.separator, line_, column);
  }

  void append(const Column& column, std::vector<double>& values) {
    if (column.found()) {
      const char* const text = normalised(column);
      values.push_back(readNumber(text, parser_.end(), column));
    }
  }

  void noteComment() {
    first_comment_ = comments_ == 0 ? line_ : first_comment_;
    ++comments_;
  }

  void addNotes() {
    const bool canonical = areCanonical(columns_) && coding_.empty() && header_.line == 1 && !header_.has_units_row &&
                           header_.separator == Separator::comma && !parser_.hasDecimalComma();
    if (!canonical) {
      log_.notes.insert(log_.notes.begin(), describeColumns(columns_, {count(), first_stamp_, last_stamp_}) + layout());
    }
    if (comments_ > 0) {
      log_.notes.push_back(fmt::format("{} comment line{} among the rows, the first line {}: left out", comments_,
                                       comments_ == 1 ? "" : "s", first_comment_));
    }
    if (!reader_->lastLineEnded()) {
      log_.notes.push_back(
          fmt::format("line {}, the last, has no line end: it may have been cut off", reader_->line()));
    }
  }

  // "; header in line 3, separator semicolon, decimal comma, UTF-16"
  std::string layout() const {
    std::string text = "; ";
    text += header_.line == 0 ? "no header" : fmt::format("header in line {}", header_.line);
    text += header_.has_units_row ? " with a row of units" : "";
    text += ", separator " + toString(header_.separator);
    text += parser_.hasDecimalComma() ? ", decimal comma" : "";
    return text + (coding_.empty() ? "" : ", " + coding_);
  }

  LogFormat format_;
  std::string coding_;
  std::unique_ptr<LineReader> reader_;
  CsvHeader header_;
  Columns columns_;
  Log log_;  // what is not handed out yet
  std::size_t handed_out_ = 0;
  std::int64_t first_stamp_ = 0;
  std::int64_t last_stamp_ = 0;
  bool ended_ = false;  // nobody takes any more
  std::size_t line_ = 1;
  std::size_t blank_line_ = 0;
  std::size_t comments_ = 0;
  std::size_t first_comment_ = 0;
  bool by_fields_ = false;  // rows are not commas and numbers alone
  std::vector<const char*> starts_;
  std::vector<Field> fields_;
  FieldParser parser_;
};

// What `read` makes of a reader of the file; errors with their line.
template <class Read>
auto withReader(const std::string& path, const LogFormat& format, const Read& read) {
  std::unique_ptr<CsvLogReader> reader;
  try {
    reader = std::make_unique<CsvLogReader>(path, format);
    return read(*reader);
  } catch (const LogError&) {
    throw;  // of who takes the samples
  } catch (const std::runtime_error& error) {
    throw LogError(reader ? fmt::format("{}:{}: {}", path, reader->line(), error.what())
                          : fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace

Log readCsvLog(const std::string& path, const LogFormat& format) {
  return withReader(path, format, [](CsvLogReader& reader) { return reader.read(); });
}

std::vector<std::string> readCsvBlocks(const std::string& path, const LogFormat& format, const LogSource::Take& take) {
  return withReader(path, format, [&](CsvLogReader& reader) { return reader.readBlocks(take); });
}

}  // namespace rubber_suspension::log
