// Logs of any source: their check, how to read them, and the CSV that is written.
#include "rubber_suspension/log/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include "element/suggestion.h"
#include "kernel/sample_checks.h"
#include "log/log_columns.h"
#include "log/new_file.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::log {
namespace {

void checkLength(const Log& log, const char* name, const std::vector<double>& values, bool may_be_missing) {
  if (values.size() != log.size() && !(values.empty() && may_be_missing)) {
    throw LogError(
        fmt::format("{}: {} has {} values; accepted: {}, one per stamp", log.name, name, values.size(), log.size()));
  }
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
    if (!std::isfinite(values[i])) {
      throw LogError(fmt::format("{}: sample {}: {} {} is not finite", log.name, i + 1, name, values[i]));
    }
  }
}

// "QUANTITY=NAME", or QUANTITY alone: the column of that place.
void setColumn(LogFormat& format, const std::string& entry, std::size_t place) {
  const std::size_t equals = entry.find('=');
  const std::string quantity = entry.substr(0, equals);
  const std::string column = equals == std::string::npos ? std::to_string(place) : entry.substr(equals + 1);
  const std::array<std::pair<const char*, std::string*>, 4> accepted = {{{"time", &format.time_column},
                                                                         {"displacement", &format.displacement_column},
                                                                         {"force", &format.force_column},
                                                                         {"temperature", &format.temperature_column}}};
  const auto found =
      std::find_if(accepted.begin(), accepted.end(), [&](const auto& pair) { return quantity == pair.first; });
  if (found == accepted.end() || column.empty()) {
    throw std::invalid_argument(fmt::format(
        "--columns: {}{}; accepted: time=NAME, displacement=NAME, force=NAME, temperature=NAME, NAME being that "
        "of the file or the column's number, or these words alone in the order of the columns",
        quoted(entry), element::didYouMean(quantity, {"time", "displacement", "force", "temperature"})));
  }
  if (!found->second->empty()) {
    throw std::invalid_argument(fmt::format("--columns: {} is given twice; accepted: once", quantity));
  }
  *found->second = column;
}

void setUnits(LogFormat& format, const std::string& units) {
  std::istringstream rest(units);
  const std::array<std::pair<std::string*, const char*>, 3> quantities = {
      {{&format.displacement_unit, "m"}, {&format.force_unit, "N"}, {&format.time_unit, "s"}}};
  try {
    for (const auto& [unit, si] : quantities) {
      std::getline(rest, *unit, ',');
      UnitConversion(unit->empty() ? si : *unit, si);
    }
    if (std::string more; std::getline(rest, more)) {
      throw std::invalid_argument("more than three");
    }
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("--unit: '{}': {}; accepted: units of displacement, force and time, as in mm,kN,ms, of which the "
                    "later ones may be left out",
                    units, error.what()));
  }
}

}  // namespace

LogError::LogError(const std::string& message) : std::runtime_error(oneLine(message)) {}

LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate) {
  LogFormat format;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    setColumn(format, columns[i], i + 1);
  }
  if (!units.empty()) {
    setUnits(format, units);
  }
  // Above 1 GHz two samples would share a nanosecond.
  if (!(rate >= 0.0 && rate <= 1e9)) {
    throw std::invalid_argument(fmt::format("--sampling-rate: {:g} Hz; accepted: greater than 0, at most 1e9", rate));
  }
  if (rate > 0.0) {
    format.rate = rate;
  }
  return format;
}

void checkLog(const Log& log) {
  checkLengths(log);
  checkSamples(log, 0, log.size());
}

void checkLengths(const Log& log) {
  if (log.size() < 2) {
    throw LogError(fmt::format("{}: {} samples; accepted: at least 2", log.name, log.size()));
  }
  checkLength(log, "displacement", log.displacement, false);
  checkLength(log, "force", log.force, true);
  checkLength(log, "temperature", log.temperature, true);
}

void checkSamples(const Log& log, std::size_t first, std::size_t count) {
  checkStamps(log, first, count);
  checkValues(log, "displacement", log.displacement, first, count);
  checkValues(log, "force", log.force, first, count);
  checkValues(log, "temperature", log.temperature, first, count);
}

void writeForceCsv(const std::string& path, const Log& log, const std::vector<double>& force) {
  if (force.size() != log.size()) {
    throw LogError(fmt::format("{}: {} forces for {} samples", path, force.size(), log.size()));
  }
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
  if (with_force_) {
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
    writer.append(log.stamp[i], log.displacement[i], log.force.empty() ? 0.0 : log.force[i]);
  }
  writer.close();
}

}  // namespace rubber_suspension::log
