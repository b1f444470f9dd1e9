// Checks logs from any source, makes formats from the options of commands, and writes CSV.
#include "rubber_suspension/log/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include "element/refuse.h"
#include "element/suggestion.h"
#include "kernel/sample_checks.h"
#include "log/log_columns.h"
#include "log/new_file.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::log {
namespace {

void checkLength(const Log& log, const char* name, const std::vector<double>& values, bool may_be_missing) {
  element::refuseIf<LogError>(values.size() != log.size() && !(values.empty() && may_be_missing),
                              "{}: {} has {} values; accepted: {}, one per stamp", log.name, name, values.size(),
                              log.size());
}

void checkStamps(const Log& log, std::size_t first, std::size_t count) {
  const std::size_t before = first == 0 ? 0 : first - 1;
  if (kernel::allIncreasing(log.stamp.data() + before, first + count - before)) {
    return;
  }
  for (std::size_t i = before + 1; i < first + count; ++i) {
    if (log.stamp[i] <= log.stamp[i - 1]) {
      throw LogError(fmt::format("{}: sample {}: time {} after {}; accepted: time that increases", log.name, i + 1,
                                 formatStamp(log.stamp[i]), formatStamp(log.stamp[i - 1])));
    }
  }
}

void checkValues(const Log& log, const char* name, const std::vector<double>& values, std::size_t first,
                 std::size_t count) {
  if (values.empty() || kernel::allFinite(values.data() + first, count)) {
    return;
  }
  for (std::size_t i = first; i < first + count; ++i) {
    element::refuseIf<LogError>(!std::isfinite(values[i]), "{}: sample {}: {} {} is not finite", log.name, i + 1, name,
                                values[i]);
  }
}

// Returns the channel of the quantity with this name; nullptr for any other word.
LogFormat::Channel* channelNamed(LogFormat& format, const std::string& quantity) {
  for (const Quantity one : kQuantities) {
    if (quantity == toString(one)) {
      return &format.of[static_cast<std::size_t>(one)];
    }
  }
  return nullptr;
}

// Parses an optional factor before the name of a column: "-NAME" or "0.001*NAME".
void setColumnAndFactor(LogFormat::Channel& channel, const std::string& text) {
  const std::size_t star = text.find('*');
  const std::optional<double> factor =
      star == std::string::npos ? std::nullopt : parseNumber(trimmed(text.substr(0, star)));
  if (factor && std::isfinite(*factor) && *factor != 0.0) {
    channel.factor = *factor;
    channel.column = trimmed(text.substr(star + 1));
  } else if (text.size() > 1 && text[0] == '-') {
    channel.factor = -1.0;
    channel.column = text.substr(1);
  } else {
    channel.column = text;
  }
}

// Parses "QUANTITY=NAME", or QUANTITY alone, which assigns the column with number `place`.
void setColumn(LogFormat& format, const std::string& entry, std::size_t place) {
  const std::size_t equals = entry.find('=');
  const std::string quantity = entry.substr(0, equals);
  const std::string column = equals == std::string::npos ? std::to_string(place) : entry.substr(equals + 1);
  LogFormat::Channel* const channel = channelNamed(format, quantity);
  const bool given_twice = channel != nullptr && !channel->column.empty();
  if (channel != nullptr && !given_twice) {
    setColumnAndFactor(*channel, column);
  }
  element::refuseIf(channel == nullptr || channel->column.empty(),
                    "--columns: {}{}; accepted: time=NAME, displacement=NAME, force=NAME, temperature=NAME, where NAME "
                    "is a name in the header or a column's number, optionally with a factor (force=-NAME, "
                    "force=0.001*NAME); or the names of the quantities alone, in the order of the columns",
                    quoted(entry), element::didYouMean(quantity, {"time", "displacement", "force", "temperature"}));
  if (given_twice) {
    throw std::invalid_argument(fmt::format("--columns: {} is given twice; accepted: once", quantity));
  }
  element::refuseIf(channel->factor != 1.0 && quantity == "temperature",
                    "--columns: the temperature has a factor; accepted: its column without a factor");
}

// Parses "force=kN". The unit may consist of several words.
void setUnitOption(LogFormat& format, const std::string& entry) {
  const std::size_t equals = entry.find('=');
  const std::string quantity = entry.substr(0, equals);
  LogFormat::Channel* const channel = equals == std::string::npos ? nullptr : channelNamed(format, quantity);
  std::string reason = "not a quantity and its unit";
  if (channel != nullptr) {
    const std::string unit = entry.substr(equals + 1);
    const std::string si = siUnit(kQuantities[static_cast<std::size_t>(channel - format.of.data())]);
    try {
      UnitConversion(spelledUnit(unit, si), si);
      reason = channel->unit.empty() ? "" : "given twice";
      channel->unit = unit;
    } catch (const std::invalid_argument& error) {
      reason = error.what();
    }
  }
  element::refuseIf(!reason.empty(),
                    "--unit: {}: {}{}; accepted: QUANTITY=UNIT, as in displacement=mm force=kN time=ms", quoted(entry),
                    reason, element::didYouMean(quantity, {"time", "displacement", "force", "temperature"}));
}

void setUnits(LogFormat& format, const std::string& units) {
  std::istringstream words(units);
  std::vector<std::string> entries;
  for (std::string word; words >> word;) {
    if (!entries.empty() && word.find('=') == std::string::npos) {
      entries.back() += " " + word;
    } else {
      entries.push_back(word);
    }
  }
  for (const std::string& entry : entries) {
    setUnitOption(format, entry);
  }
}

char decimalMark(const std::string& text) {
  if (text == "." || text == "point") {
    return '.';
  }
  if (text == "," || text == "comma") {
    return ',';
  }
  throw std::invalid_argument(fmt::format(
      "--decimal: {}; accepted: , or . (comma or point), or one of these for a single column, such as force=,",
      quoted(text)));
}

// Parses ",", which applies to all columns, or "force=,", which applies to one.
void setDecimal(LogFormat& format, const std::string& text) {
  const std::size_t sign = text.find('=');
  LogFormat::Channel* const channel =
      sign == std::string::npos ? nullptr : channelNamed(format, trimmed(text.substr(0, sign)));
  if (channel != nullptr) {
    channel->decimal = decimalMark(trimmed(text.substr(sign + 1)));
  } else {
    format.decimal = decimalMark(text);
  }
}

std::size_t segmentNumber(const std::string& text) {
  const std::size_t number = text == "all" ? kAllSegments : wholeNumber(text, 6);
  element::refuseIf(number == 0, "--segment: {}; accepted: a number from 1, or all", quoted(text));
  return number;
}

}  // namespace

LogError::LogError(const std::string& message) : std::runtime_error(oneLine(message)) {}

LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate) {
  LogFormat format;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    setColumn(format, columns[i], i + 1);
  }
  setUnits(format, units);
  // At a rate above 1 GHz two samples would have the same stamp in nanoseconds.
  element::refuseIf(!(rate >= 0.0 && rate <= 1e9), "--sampling-rate: {:g} Hz; accepted: greater than 0, at most 1e9",
                    rate);
  if (rate > 0.0) {
    format.rate = rate;
  }
  return format;
}

LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate,
                        const std::string& decimal, const std::string& segment, double bridge,
                        const std::string& sentinel, const std::string& clock) {
  LogFormat format = makeLogFormat(columns, units, rate);
  if (!decimal.empty()) {
    setDecimal(format, decimal);
  }
  format.segment = segment.empty() ? 0 : segmentNumber(segment);
  constexpr double kLongestBridge = 3600.0;  // [s]
  element::refuseIf(!(bridge <= kLongestBridge), "--bridge: {:g} s; accepted: 0 to {:g} s", bridge, kLongestBridge);
  if (bridge >= 0.0) {
    format.bridge = bridge;
  }
  if (!sentinel.empty()) {
    format.sentinel = sentinel == "none" ? std::numeric_limits<double>::quiet_NaN() : parseNumber(sentinel);
    element::refuseIf(!format.sentinel,
                      "--sentinel: {} is not a number; accepted: none, or the number that marks missing values",
                      quoted(sentinel));
  }
  element::refuseIf(!clock.empty() && clock != "receipt" && clock != "header",
                    "--clock: {}; accepted: receipt or header", quoted(clock));
  format.by_receipt = clock == "receipt";
  return format;
}

Log onlyLog(const std::string& path, std::vector<Log>&& logs) {
  element::refuseIf<LogError>(logs.size() != 1,
                              "{}: the file contains {} logs, but one is needed; accepted: --segment 1 to {}", path,
                              logs.size(), logs.size());
  return std::move(logs.front());
}

std::optional<std::size_t> chosenSegment(const LogFormat& format, const std::vector<std::string>& segments) {
  if (format.segment == kAllSegments || (segments.size() == 1 && format.segment <= 1)) {
    return format.segment == kAllSegments ? std::nullopt : std::optional<std::size_t>(0);
  }
  if (format.segment >= 1 && format.segment <= segments.size()) {
    return format.segment - 1;
  }
  constexpr std::size_t kMostNamed = 6;
  const std::vector<std::string> named(
      segments.begin(), segments.begin() + static_cast<std::ptrdiff_t>(std::min(segments.size(), kMostNamed)));
  throw std::runtime_error(
      fmt::format("the file contains {} log{}: {}{}; accepted: --segment 1{}", segments.size(),
                  segments.size() == 1 ? "" : "s", join(named), segments.size() > kMostNamed ? ", ..." : "",
                  segments.size() == 1
                      ? ""
                      : fmt::format(" to {}, or --segment all in commands that accept several logs", segments.size())));
}

std::string segmentName(const std::string& file, std::size_t number) { return fmt::format("{}_{}", file, number); }

void checkLog(const Log& log) {
  checkLengths(log);
  checkSamples(log, 0, log.size());
}

void checkLengths(const Log& log) {
  element::refuseIf<LogError>(log.size() < 2, "{}: {} samples; accepted: at least 2", log.name, log.size());
  checkLength(log, "displacement", log.displacement, false);
  checkLength(log, "force", log.force, true);
  checkLength(log, "temperature", log.temperature, true);
  checkLength(log, "counts", log.counts, true);
}

void checkSamples(const Log& log, std::size_t first, std::size_t count) {
  checkStamps(log, first, count);
  checkValues(log, "displacement", log.displacement, first, count);
  checkValues(log, "force", log.force, first, count);
  checkValues(log, "temperature", log.temperature, first, count);
}

void writeForceCsv(const std::string& path, const Log& log, const std::vector<double>& force) {
  element::refuseIf<LogError>(force.size() != log.size(), "{}: {} forces for {} samples", path, force.size(),
                              log.size());
  Log answered;
  answered.stamp = log.stamp;
  answered.displacement = log.displacement;
  answered.force = force;
  writeLogCsv(path, answered);
}

LogCsvWriter::LogCsvWriter(const std::string& path, bool with_force) : path_(path), with_force_(with_force) {
  try {
    new_file_ = std::make_unique<NewFile>(path);
  } catch (const std::runtime_error& error) {
    throw LogError(error.what());
  }
  file_.open(new_file_->writingPath(), std::ios::binary);
  file_ << "time_s,displacement_m" << (with_force ? ",force_N\n" : "\n");
  if (!file_) {
    fail();
  }
}

LogCsvWriter::~LogCsvWriter() = default;

void LogCsvWriter::fail() const {
  throw LogError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

void LogCsvWriter::append(std::int64_t stamp, double displacement, double force) {
  fmt::memory_buffer row;
  fmt::format_to(std::back_inserter(row), "{},{:.17g}", formatStamp(stamp), displacement);
  if (with_force_ && std::isnan(force)) {  // the force was not measured
    row.push_back(',');
  } else if (with_force_) {
    fmt::format_to(std::back_inserter(row), ",{:.17g}", force);
  }
  row.push_back('\n');
  if (!file_.write(row.data(), static_cast<std::streamsize>(row.size()))) {
    fail();
  }
}

void LogCsvWriter::close() {
  file_.close();
  if (!file_) {
    fail();
  }
  try {
    new_file_->commit();
  } catch (const std::runtime_error& error) {
    throw LogError(error.what());
  }
}

void writeLogCsv(const std::string& path, const Log& log) {
  LogCsvWriter writer(path, !log.force.empty());
  for (std::size_t i = 0; i < log.size(); ++i) {
    const bool measured = log.counts.empty() || log.counts[i] > 0.0;
    writer.append(log.stamp[i], log.displacement[i],
                  log.force.empty() ? 0.0
                  : measured        ? log.force[i]
                                    : std::numeric_limits<double>::quiet_NaN());
  }
  writer.close();
}

}  // namespace rubber_suspension::log
