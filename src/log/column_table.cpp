// A log from a file of whole columns.
#include "log/column_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "log/log_columns.h"

namespace rubber_suspension::log {
namespace {

std::vector<double> readFinite(const Column& column, const ReadColumn& read) {
  std::vector<double> values = read(column.index, column.name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      throw std::runtime_error(
          fmt::format("{}: element {}: {} is not finite; accepted: a finite number", column.name, i + 1, values[i]));
    }
  }
  return values;
}

std::vector<double> readConverted(const Column& column, const ReadColumn& read) {
  std::vector<double> values = column.found() ? readFinite(column, read) : std::vector<double>();
  std::transform(values.begin(), values.end(), values.begin(), column.conversion);
  return values;
}

void appendStamps(Log& log, const Column& time, const ReadColumn& read) {
  const std::vector<double> times = readFinite(time, read);
  for (std::size_t i = 0; i < times.size(); ++i) {
    try {
      const std::int64_t stamp = toStamp(times[i], time);
      requireIncrease(log.stamp, stamp, time);
      log.stamp.push_back(stamp);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("element {}: {}", i + 1, error.what()));
    }
  }
}

}  // namespace

Log logFromColumns(const std::vector<ColumnName>& names, const ReadColumn& read, const LogFormat& format,
                   const std::string& name) {
  const Columns columns = findColumns(names, format);
  Log log;
  log.name = name;
  log.notes = notesOnIgnored(names, columns, format);
  log.displacement = readConverted(columns.displacement, read);
  log.force = readConverted(columns.force, read);
  log.temperature = readConverted(columns.temperature, read);
  if (format.rate) {
    for (std::size_t i = 0; i < log.displacement.size(); ++i) {
      log.stamp.push_back(stampAtRate(i, *format.rate));
    }
  } else {
    appendStamps(log, columns.time, read);
  }
  checkLog(log);
  if (!areCanonical(columns)) {
    log.notes.insert(log.notes.begin(), describeColumns(columns, log));
  }
  return log;
}

}  // namespace rubber_suspension::log
