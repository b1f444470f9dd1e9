// Reads a log from text.
#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "element/refuse.h"
#include "log/csv_dialect.h"
#include "log/file_readers.h"
#include "log/log_columns.h"
#include "log/new_file.h"
#include "log/number_marks.h"
#include "log/sample_rules.h"
#include "log/samples.h"
#include "log/text.h"
#include "log/text_source.h"
#include "log/time_text.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::log {
namespace {

// Returns true for the text that instruments and spreadsheets write in place of a missing number: an empty field, a
// word without digits such as Overrun, #N/A or --, and 1.#QNAN of Microsoft's C library.
bool isUnmeasured(const std::string& text) {
  return text.find_first_of("0123456789") == std::string::npos || text.find(".#") != std::string::npos;
}

std::string reasonOf(const std::string& text, const Column& column) {
  const auto number = parseNumber(text);
  return column.name + ": " +
         (text.empty() ? "empty field"
          : number     ? quoted(text) + " is not finite"
                       : quoted(text) + " is not a number");
}

// Finds where each field of a row begins, and appends the position behind the last field, so that field i ends one
// character before starts[i + 1]. Returns false for a row with quotes, or with a blank behind a sign.
bool splitRow(const char* line, std::vector<const char*>& starts) {
  starts.clear();
  starts.push_back(line);
  const char* c = line;
  for (; *c != '\0'; ++c) {
    if (*c == ',') {
      starts.push_back(c + 1);
    } else if (*c == '"' || (*c == ' ' && c != line && (c[-1] == '+' || c[-1] == '-'))) {
      return false;
    }
  }
  starts.push_back(c + 1);
  return true;
}

std::vector<char> ownMarks(const LogFormat& format) {
  std::vector<char> marks;
  for (const LogFormat::Channel& channel : format.of) {
    marks.push_back(channel.decimal);
  }
  return marks;
}

// A time without a unit counts days since the end of 1899, as in spreadsheets, if its value is between these limits.
constexpr long double kFirstDay = 20000.0L;  // a day in 1954
constexpr long double kLastDay = 80000.0L;   // a day in 2119
constexpr long double kDaysBefore1970 = 25569.0L;

// The number of lines of some kind, and the first of these lines.
struct Lines {
  std::size_t count = 0;
  std::size_t first = 0;

  void add(std::size_t line) { first = count++ == 0 ? line : first; }
};

class CsvLogReader {
 public:
  CsvLogReader(const std::string& path, const LogFormat& format, char found_mark)
      : path_(path), file_(logName(path)), format_(format), marks_(format.decimal, found_mark, ownMarks(format)) {
    TextSource source = openText(path, format.large);
    coding_ = source.coding;
    reader_ = std::make_unique<LineReader>(std::move(source.bytes), kMaximumLogLine);
  }

  std::vector<Log> read() {
    readFile(nullptr);
    return std::move(logs_);
  }

  std::vector<std::string> readBlocks(const LogSource::Take& take) {
    readFile(&take);
    return ended_ ? std::vector<std::string>() : std::move(logs_.front().notes);
  }

  /// Returns the number of the line to which errors refer.
  std::size_t line() const { return line_; }

  bool hasHandedOut() const { return handed_out_ > 0; }

 private:
  // Passes the samples to `take`, or keeps all of them if `take` is null.
  void readFile(const LogSource::Take* take) {
    take_ = take;
    std::vector<TextLine> head;
    header_ = firstHeader(head);
    startSegment(head);
    while (!ended_ && !isPastChosen()) {
      const char* const line = nextLine();
      if (line == nullptr) {
        break;
      }
      readRow(line);
    }
    if (!ended_ && !isPastChosen()) {
      line_ = std::max<std::size_t>(reader_->line(), 1);
      endSegment(false);
      requireSegment();
    }
  }

  // Returns the next line. The lines that were read ahead in search of a header come first.
  const char* nextLine() {
    if (read_ahead_.empty()) {
      line_ = reader_->line() + 1;
      return reader_->next();
    }
    current_ = std::move(read_ahead_.front());
    read_ahead_.pop_front();
    line_ = current_.number;
    return current_.text.c_str();
  }

  void requireSegment() const {
    try {
      chosenSegment(format_, segments_);
    } catch (const std::runtime_error& error) {
      const bool one_run = restarts_ + 1 == segments_.size() && restart_rate_ > 0.0;
      throw LogError(fmt::format(
          "{}: {}{}", path_, error.what(),
          one_run ? fmt::format(", because the time restarts; if all parts are one log, use --sampling-rate {:.6g}",
                                restart_rate_)
                  : ""));
    }
  }

  bool isPastChosen() const { return format_.segment > 0 && segments_.size() >= format_.segment; }

  // Returns true if the format requests the segment that is being read.
  bool isWanted() const {
    return format_.segment == kAllSegments || segments_.size() + 1 == std::max<std::size_t>(format_.segment, 1);
  }

  CsvHeader firstHeader(std::vector<TextLine>& head) {
    HeaderFinder finder(format_);
    const auto found = searchHeader(finder, head);
    line_ = 1;
    refuseEmpty(head);
    return found ? *found : finder.finish();
  }

  // Reads lines into `head` until a header is found, the file ends or `head` is too long.
  std::optional<CsvHeader> searchHeader(HeaderFinder& finder, std::vector<TextLine>& head) {
    std::optional<CsvHeader> header;
    for (const TextLine& line : head) {
      header = finder.add(line);
    }
    while (!header && head.size() < kMaximumHeadLines) {
      const char* line = nextLine();
      if (line == nullptr) {
        break;
      }
      head.push_back({line_, line});
      header = finder.add(head.back());
    }
    return header;
  }

  // Begins a segment. The lines of `head` after the header are read as rows.
  void startSegment(const std::vector<TextLine>& head) {
    line_ = std::max<std::size_t>(header_.line, 1);
    columns_ = findColumns(header_.names, format_);
    resolveTime(head);
    beginRows();
    const std::vector<char> own = ownMarks(format_);
    by_fields_ = header_.separator != Separator::comma || format_.decimal == ',' ||
                 std::find(own.begin(), own.end(), ',') != own.end();
    readAhead(head, header_.next_line);
  }

  // Puts back the lines of `head` from line number `first` on, so that they are read as rows.
  void readAhead(const std::vector<TextLine>& head, std::size_t first) {
    const auto rows =
        std::find_if(head.begin(), head.end(), [&](const TextLine& line) { return line.number >= first; });
    read_ahead_.insert(read_ahead_.begin(), rows, head.end());
  }

  // Returns true if a header repeats the present one and the time continues, as in files with a header for each buffer.
  bool isContinued(const CsvHeader& header, const std::vector<TextLine>& head) {
    const auto row = firstRow(head, header.next_line);
    if (!columns_.time.found() || header.separator != header_.separator || header.names != header_.names ||
        row == head.end()) {
      return false;
    }
    row_ = SampleRow();
    try {
      parseRowByFields(row->text.c_str());
    } catch (const std::runtime_error&) {
      return false;
    }
    return rules_->continues(row_.stamp);
  }

  // Returns the first line from line number `first` on that is neither blank nor a comment.
  static std::vector<TextLine>::const_iterator firstRow(const std::vector<TextLine>& head, std::size_t first) {
    return std::find_if(head.begin(), head.end(), [&](const TextLine& line) {
      return line.number >= first && !trimmed(line.text).empty() && !isComment(line.text);
    });
  }

  void beginRows() {
    log_ = Log();
    log_.units = unitsOf(columns_, format_);
    log_.notes = notesOnIgnored(header_.names, columns_, format_);
    rules_.emplace(format_, columns_, "line");
    clock_ = TimeTextReader();
    first_row_ = 0;
    blank_line_ = 0;
    comments_ = repeats_ = statistics_ = {};
  }

  void endSegment(bool another_follows) {
    const bool wanted = isWanted();
    element::refuseIf<std::runtime_error>(segments_.size() == kMaximumSegments,
                                          "more than {0} segments; accepted: at most {0}", kMaximumSegments);
    segments_.push_back(fmt::format("lines {} to {}{}", first_row_, last_row_, border_));
    // If the format selects no segment, a file with several segments is refused after all of them have been read.
    if (!wanted || (format_.segment == 0 && another_follows)) {
      return;
    }
    marks_.requireClear(
        {columns_.time.name, columns_.displacement.name, columns_.force.name, columns_.temperature.name}, true);
    rules_->finish(log_);
    addNotes();
    if (take_ != nullptr && log_.size() > 0) {
      handOut();
    }
    log_.name = format_.segment == 0 ? file_ : segmentName(file_, segments_.size());
    logs_.push_back(std::move(log_));
  }

  // Ends the segment at a line that is no row. Throws unless a header follows, or rows follow after a blank line.
  void endSegmentAt(const char* line, const std::runtime_error& error) {
    const std::size_t error_line = line_;
    const bool behind_blank = blank_line_ != 0;
    std::vector<TextLine> head = {{line_, line}};
    HeaderFinder finder(format_);
    auto header = searchHeader(finder, head);
    header = header ? header : finder.atEnd(true);
    if (!header || (header->line == 0 && !behind_blank)) {
      throw RowError(error_line, error.what());
    }
    if (isContinued(*header, head)) {
      repeats_.add(header->line);
      blank_line_ = 0;
      readAhead(head, header->next_line);
      return;
    }
    endSegment(true);
    border_ = "";
    header_ = *header;
    startSegment(head);
  }

  // Begins a segment without a header, after a blank line or where the time restarts.
  void beginAnotherLog() {
    const bool restarts = blank_line_ == 0;
    restart_rate_ = restarts && restarts_ == 0 ? rules_->rate() : restart_rate_;
    restarts_ += restarts ? 1 : 0;
    endSegment(true);
    border_ = restarts ? "" : fmt::format(" (another log, because line {} is blank)", blank_line_);
    beginRows();
  }

  static void refuseEmpty(const std::vector<TextLine>& head) {
    element::refuseIf<std::runtime_error>(head.empty(), "the file is empty; accepted: a header and at least 2 rows");
    if (std::all_of(head.begin(), head.end(), [](const TextLine& line) { return trimmed(line.text).empty(); })) {
      throw std::runtime_error("the header is blank; accepted: time_s,displacement_<unit>,...");
    }
  }

  // Interprets a column of time that states no unit. Its first cell may be a time of day or a date. A decimal number
  // between kFirstDay and kLastDay counts days, as in spreadsheets.
  void resolveTime(const std::vector<TextLine>& head) {
    days_ = false;
    const auto row = firstRow(head, header_.next_line);
    if (!columns_.time.found() || columns_.time.tells_unit || row == head.end()) {
      requireTimeUnit(columns_, format_);
      return;
    }
    splitFields(row->text, header_.separator, fields_);
    const std::string text(columns_.time.index < fields_.size() ? fields_[columns_.time.index].text : "");
    if (isTimeText(text)) {
      columns_.time.assumed_unit.clear();
      return;
    }
    constexpr std::size_t kSince1970 = 17;  // nanoseconds since 1970 have at least so many digits from 1973 on
    const bool whole = text.find_first_not_of("0123456789") == std::string::npos;
    if (whole && text.size() >= kSince1970 && !format_.rate) {
      throw std::runtime_error(fmt::format(
          "column {} has no unit; if {} is a time, it is in nanoseconds since 1970; accepted: --unit time=ns",
          quoted(columns_.time.name), text));
    }
    std::string point = text;
    std::replace(point.begin(), point.end(), ',', '.');
    const double day = parseNumber(point).value_or(0.0);
    days_ = point.find('.') != std::string::npos && day > kFirstDay && day < kLastDay;
    if (days_) {
      columns_.time.conversion = UnitConversion("day", "s");
      columns_.time.assumed_unit = "days since 1899, as spreadsheets count them";
    }
    requireTimeUnit(columns_, format_);
  }

  void readRow(const char* line) {
    const char* const text = line + std::strspn(line, " \t");
    if (text[std::strspn(text, " \t,;\"")] == '\0') {  // a line of blanks or separators only, as spreadsheets write it
      blank_line_ = blank_line_ == 0 ? line_ : blank_line_;
      return;
    }
    if (std::strchr("#%!/", *text) != nullptr && isComment(text)) {
      comments_.add(line_);
      return;
    }
    if (first_row_ != 0 && !lettered_ && beginsWithLetter(text) && isStatistics(text)) {
      statistics_.add(line_);
      return;
    }
    lettered_ = first_row_ == 0 ? beginsWithLetter(text) : lettered_;
    try {
      row_ = SampleRow();
      if (by_fields_ || !parsePlainRow(line)) {
        parseRowByFields(line);
      }
    } catch (const std::runtime_error& error) {
      const bool any_row = first_row_ != 0;
      if (!any_row) {
        throw;
      }
      endSegmentAt(line, error);
      return;
    }
    const bool lacks_value = !row_.unmeasured[0].empty() || !row_.unmeasured[1].empty();
    if (isNoRow() || (lacks_value && blank_line_ != 0 && first_row_ != 0)) {
      const std::string& reason = row_.unmeasured[row_.unmeasured[0].empty() ? 1 : 0];
      endSegmentAt(line, std::runtime_error(reason + "; accepted: a finite number"));
      return;
    }
    if ((blank_line_ != 0 && first_row_ != 0) || rules_->restarts(row_)) {
      beginAnotherLog();
      if (isPastChosen()) {
        return;
      }
    }
    takeRow();
  }

  // Returns true for a line in which no quantity has a value; such a line is text.
  bool isNoRow() const {
    const bool time = format_.rate || !row_.stamp;
    return first_row_ != 0 && time && std::isnan(row_.value[kMotion]) && std::isnan(row_.value[kForce]) &&
           std::isnan(row_.value[kTemperature]);
  }

  static bool beginsWithLetter(const char* text) {
    const char first = text[text[0] == '"' ? 1 : 0];
    return (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
  }

  // Returns true for a row of statistics, such as "Min" or "Mittelwert:", that some instruments append to the data.
  bool isStatistics(const char* line) {
    static const std::array<const char*, 22> kWords = {
        "min",    "minimum", "max",     "maximum", "mean",       "average",           "avg",   "rms",
        "median", "std",     "std dev", "stdev",   "stddev",     "std. dev.",         "range", "sum",
        "total",  "p-p",     "pk-pk",   "summe",   "mittelwert", "standardabweichung"};
    splitFields(line, header_.separator, fields_);
    std::string word = lowerCase(std::string(fields_.front().text));
    word.resize(word.find_last_not_of(" :=") + 1);
    return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
  }

  void takeRow() {
    if (statistics_.count > 0) {
      throw RowError(statistics_.first, "data follow this row of statistics; accepted: rows of numbers");
    }
    blank_line_ = 0;
    first_row_ = first_row_ == 0 ? line_ : first_row_;
    last_row_ = line_;
    if (!isWanted() && log_.size() >= kLogBlock) {
      log_ = Log();  // the samples belong to a segment that is not requested
    }
    if (log_.size() >= kMaximumLogRows) {  // never reached if blocks are passed on
      throw std::runtime_error(fmt::format("more than {0} rows; accepted: at most {0}", kMaximumLogRows));
    }
    row_.place = line_;
    rules_->take(row_, log_);
    if (take_ != nullptr && isWanted() && log_.size() >= kLogBlock) {
      handOut();
    }
  }

  void handOut() {
    log_.name = format_.segment == 0 ? file_ : segmentName(file_, format_.segment);
    ended_ = !handOutBlocks(log_, kLogBlock, *take_, handed_out_);
    log_.stamp.clear();
    log_.counts.clear();
    for (const auto channel : kChannels) {
      (log_.*channel).clear();
    }
  }

  // Parses a row of plain numbers and commas quickly. Returns false if the number of fields differs from the header.
  bool parsePlainRow(const char* line) {
    if (!splitRow(line, starts_) || starts_.size() - 1 != columns_.count) {
      return false;
    }
    const auto parse = [&](const Column& column, Quantity quantity) {
      const char* const field = starts_[column.index];
      const char* const field_end = starts_[column.index + 1] - 1;
      const double value =
          quantity == Quantity::time ? readStamp(field, field_end) : readNumber(field, field_end, quantity);
      marks_.seePlain(field, field_end, value, channelOf(quantity), line_);
      return value;
    };
    readValues(parse);
    return true;
  }

  template <class Parse>
  void readValues(const Parse& parse) {
    if (columns_.time.found()) {
      parse(columns_.time, Quantity::time);
    }
    row_.value[kMotion] = parse(columns_.displacement, Quantity::displacement);
    if (columns_.force.found()) {
      row_.value[kForce] = parse(columns_.force, Quantity::force);
    }
    if (columns_.temperature.found()) {
      row_.value[kTemperature] = parse(columns_.temperature, Quantity::temperature);
    }
  }

  void parseRowByFields(const char* line) {
    splitFields(line, header_.separator, fields_);
    while (fields_.size() > columns_.count && fields_.back().text.empty() && !fields_.back().quoted) {
      fields_.pop_back();  // the line ends in a separator
    }
    if (header_.comments_follow && fields_.size() == columns_.count + 1) {
      fields_.pop_back();
    }
    if (fields_.size() != columns_.count) {
      throw std::runtime_error(fmt::format("the row has {} field{}; accepted: {}, as in the header: {}", fields_.size(),
                                           fields_.size() == 1 ? "" : "s", columns_.count, quoted(line)));
    }
    readValues([&](const Column& column, Quantity quantity) {
      const char* const text = marks_.normalised(fields_[column.index].text, channelOf(quantity), column.name, line_);
      const double value =
          quantity == Quantity::time ? readStamp(text, marks_.end()) : readNumber(text, marks_.end(), quantity);
      marks_.see(value, channelOf(quantity));
      return value;
    });
  }

  // Returns the number in a field. Returns NaN, and adds the reason to the row, if the field states that nothing was
  // measured. Throws for any other text.
  double readNumber(const char* field, const char* field_end, Quantity quantity) {
    char* parsed_end = nullptr;
    const double value = strtod_l(field, &parsed_end, cLocale());
    if (parsed_end == field_end && parsed_end != field && std::isfinite(value) && !isHexadecimal(field)) {
      return value;
    }
    return isNumberBefore(field, parsed_end, field_end) && std::isfinite(value)
               ? value
               : unmeasured(field, field_end, quantity);
  }

  // strtod accepts hexadecimal numbers, which are refused here. Blanks may follow a number.
  static bool isHexadecimal(const char* field) { return std::strpbrk(field, "xX") != nullptr; }
  static bool isNumberBefore(const char* field, const char* parsed_end, const char* field_end) {
    const char* c = parsed_end;
    while (c != field_end && (*c == ' ' || *c == '\t')) {
      ++c;
    }
    return c == field_end && parsed_end != field &&
           std::none_of(field, field_end, [](char x) { return x == 'x' || x == 'X'; });
  }

  double unmeasured(const char* field, const char* field_end, Quantity quantity) {
    const std::string text = trimmed(std::string(field, static_cast<std::size_t>(field_end - field)));
    const std::string reason = reasonOf(text, columns_.of(quantity));
    if (!isUnmeasured(text) && quantity != Quantity::temperature) {  // any text is accepted as a missing temperature
      throw std::runtime_error(reason + "; accepted: a finite number");
    }
    const std::size_t place = channelOf(quantity);
    row_.unmeasured[place] = reason;
    if (quantity != Quantity::time) {
      row_.faulty[place - 1] = !text.empty() && lowerCase(text) != "nan";
    }
    return kNotMeasured;
  }

  // Returns the time as in the file and sets the stamp. The time is parsed as long double, because a double cannot
  // represent nanoseconds since 1970. If the format gives a rate, a time that cannot be read is ignored.
  double readStamp(const char* field, const char* field_end) {
    double time = kNotMeasured;
    try {
      char* parsed_end = nullptr;
      const long double value = strtold_l(field, &parsed_end, cLocale());
      if (isNumberBefore(field, parsed_end, field_end) && std::isfinite(value)) {
        time = static_cast<double>(value);
        row_.stamp = toStamp(days_ ? value - kDaysBefore1970 : value, columns_.time);
        return time;
      }
      row_.stamp = clock_.read(trimmed(std::string(field, static_cast<std::size_t>(field_end - field))));
      if (!row_.stamp) {
        unmeasured(field, field_end, Quantity::time);
      }
    } catch (const std::runtime_error&) {
      if (!format_.rate) {
        throw;
      }
      row_.stamp.reset();
    }
    return time;
  }

  static std::size_t channelOf(Quantity quantity) { return static_cast<std::size_t>(quantity); }

  void addNotes() {
    const bool canonical = areCanonical(columns_) && coding_.empty() && header_.line == 1 && !header_.has_units_row &&
                           header_.separator == Separator::comma && !marks_.hasDecimalComma() &&
                           !marks_.hasThousands() && segments_.size() == 1;
    if (!canonical) {
      log_.notes.insert(log_.notes.begin(), describeColumns(columns_, rules_->extent()) + layout());
    }
    for (std::string& note : rules_->notes()) {
      log_.notes.push_back(std::move(note));
    }
    if (comments_.count > 0) {
      log_.notes.push_back(fmt::format("{} comment line{} among the rows, the first in line {}: skipped",
                                       comments_.count, pluralOf(comments_.count), comments_.first));
    }
    if (repeats_.count > 0) {
      log_.notes.push_back(
          fmt::format("the header is repeated {} time{} while time continues, first in line {}: read as one log",
                      repeats_.count, pluralOf(repeats_.count), repeats_.first));
    }
    if (statistics_.count > 0) {
      log_.notes.push_back(fmt::format("{} row{} of statistics below the data, from line {} on: skipped",
                                       statistics_.count, pluralOf(statistics_.count), statistics_.first));
    }
    if (!reader_->lastLineEnded()) {
      log_.notes.push_back(
          fmt::format("the last line, {}, has no line end; it may have been cut off", reader_->line()));
    }
  }

  // Returns for example "; header in line 3, separator semicolon, decimal comma, UTF-16".
  std::string layout() const {
    std::string text = "; ";
    text += header_.line == 0 ? "no header" : fmt::format("header in line {}", header_.line);
    text += header_.has_units_row ? " with a row of units" : "";
    text += ", separator " + toString(header_.separator);
    text += marks_.hasDecimalComma() ? ", decimal comma" : "";
    text += marks_.hasThousands() ? ", thousands separators" : "";
    return text + (coding_.empty() ? "" : ", " + coding_);
  }

  std::string path_;
  std::string file_;
  LogFormat format_;
  std::string coding_;
  std::unique_ptr<LineReader> reader_;
  const LogSource::Take* take_ = nullptr;
  std::vector<Log> logs_;              // requested segments that are complete
  std::vector<std::string> segments_;  // descriptions of all complete segments
  std::string border_;                 // reason why the present segment begins
  CsvHeader header_;
  std::deque<TextLine> read_ahead_;
  TextLine current_;  // line last taken from read_ahead_
  Columns columns_;
  std::optional<SampleRules> rules_;
  Log log_;  // samples that are not yet passed on
  std::size_t handed_out_ = 0;
  bool ended_ = false;        // true once `take` has returned false
  std::size_t restarts_ = 0;  // how often the time restarted
  double restart_rate_ = 0.0;
  std::size_t line_ = 1;
  std::size_t first_row_ = 0;  // line number of the first row of the segment
  std::size_t last_row_ = 0;
  std::size_t blank_line_ = 0;
  Lines comments_;  // comments among the rows of the segment
  Lines repeats_;   // repeated headers within the segment
  Lines statistics_;
  bool lettered_ = false;   // true if the first row begins with a letter
  bool by_fields_ = false;  // true if rows contain more than plain numbers and commas
  bool days_ = false;       // true if the time counts days, as in spreadsheets
  TimeTextReader clock_;
  SampleRow row_;
  std::vector<const char*> starts_;
  std::vector<Field> fields_;
  NumberMarks marks_;
};

// Returns the result of `read` for a reader of the file. Adds the path and the line number to errors.
template <class Read>
auto withReader(const std::string& path, const LogFormat& format, const Read& read, char found_mark = '\0') {
  std::unique_ptr<CsvLogReader> reader;
  try {
    reader = std::make_unique<CsvLogReader>(path, format, found_mark);
    return read(*reader);
  } catch (const OtherDecimalMark& other) {
    if (found_mark == '\0' && !reader->hasHandedOut() && !isStream(path)) {
      return withReader(path, format, read, other.decimal);
    }
    throw LogError(
        fmt::format("{}:{}: with this decimal {}, earlier marks may be thousands separators; accepted: --decimal {}",
                    path, reader->line(), other.decimal == ',' ? "comma" : "point", other.decimal));
  } catch (const LogError&) {
    throw;  // thrown by the consumer of the samples
  } catch (const RowError& error) {
    throw LogError(fmt::format("{}:{}: {}", path, error.row(), error.what()));
  } catch (const std::runtime_error& error) {
    throw LogError(reader ? fmt::format("{}:{}: {}", path, reader->line(), error.what())
                          : fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace

Log readCsvLog(const std::string& path, const LogFormat& format) { return onlyLog(path, readCsvLogs(path, format)); }

std::vector<Log> readCsvLogs(const std::string& path, const LogFormat& format) {
  return withReader(path, format, [](CsvLogReader& reader) { return reader.read(); });
}

std::vector<std::string> readCsvBlocks(const std::string& path, const LogFormat& format, const LogSource::Take& take) {
  return withReader(path, format, [&](CsvLogReader& reader) { return reader.readBlocks(take); });
}

}  // namespace rubber_suspension::log
