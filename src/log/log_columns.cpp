// Which columns of a file are read, and how their numbers become SI.
#include "log/log_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "log/text.h"

namespace rubber_suspension::log {
namespace {

// 285 years: stamps stay well within 64 bits of nanoseconds.
constexpr double kMaximumTime = 9.0e9;  // [s]
const std::vector<std::string> kTimeUnits = {"s", "ms", "us"};
const std::vector<std::string> kDisplacementUnits = {"m", "mm", "um"};
const std::vector<std::string> kForceUnits = {"N", "kN", "MN"};

// The names of a header for an error, the first of them if there are many.
std::string listed(std::vector<std::string> header) {
  constexpr std::size_t kMost = 12;
  const bool more = header.size() > kMost;
  header.resize(std::min(header.size(), kMost));
  std::transform(header.begin(), header.end(), header.begin(), quoted);
  return join(header) + (more ? ", ..." : "");
}

std::size_t findName(const std::vector<std::string>& header, const std::string& name) {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) {
    return Column::kNone;
  }
  if (std::find(found + 1, header.end(), name) != header.end()) {
    throw std::runtime_error(fmt::format("column {} stands twice in the header; accepted: once", quoted(name)));
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
    throw std::runtime_error(
        fmt::format("no column {}, the header has {}; accepted: a file with that column, or another "
                    "name by --columns{}",
                    quoted(name), listed(header), name == "time_s" ? ", or --rate" : ""));
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
    throw std::runtime_error(fmt::format("column {} has no accepted unit; accepted: {}, or --columns with --unit",
                                         quoted(*alike), join(namesWithUnits(quantity, units))));
  }
  return result;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// The unit that a name of a file's own ends in, `D_mm`, `D [mm]` or `D (mm)`, if it is one of the quantity; else empty.
std::string unitInName(const std::string& name, const std::vector<std::string>& units) {
  for (const std::string& unit : units) {
    if (endsWith(name, "_" + unit)) {
      return unit;
    }
  }
  const std::size_t open = name.find_last_of("[(");
  if (open == std::string::npos || !(endsWith(name, "]") || endsWith(name, ")"))) {
    return {};
  }
  std::string unit = trimmed(name.substr(open + 1, name.size() - open - 2));
  try {
    UnitConversion(unit, units.front());
    return unit;
  } catch (const std::invalid_argument&) {  // something else is in brackets
    return {};
  }
}

Column mappedColumn(const std::vector<std::string>& header, const std::string& name, const std::string& unit,
                    const std::vector<std::string>& units) {
  Column column = requireColumn(header, name);
  const std::string used = unit.empty() ? unitInName(name, units) : unit;
  column.assumed_unit = used.empty() ? units.front() : "";
  column.conversion = UnitConversion(used.empty() ? units.front() : used, units.front());
  return column;
}

// A column of displacement or force: by the name that the user gave, else quantity_<unit>, else the bare quantity if
// the user gave its unit.
Column findQuantity(const std::vector<std::string>& header, const std::string& quantity, const std::string& name,
                    const std::string& unit, const std::vector<std::string>& units) {
  if (!name.empty()) {
    return mappedColumn(header, name, unit, units);
  }
  if (!unit.empty() && namedColumn(header, quantity).found()) {
    return mappedColumn(header, quantity, unit, units);
  }
  return columnWithUnit(header, quantity, units);
}

void noteUnusedUnit(std::vector<std::string>& notes, const Column& column, const std::string& quantity,
                    const std::string& unit) {
  const bool by_its_name = column.name.compare(0, quantity.size() + 1, quantity + "_") == 0;
  if (!unit.empty() && by_its_name) {
    notes.push_back(fmt::format("unit {} is not used: column '{}' names its own", quoted(unit), column.name));
  }
}

}  // namespace

Columns findColumns(const std::vector<std::string>& header, const LogFormat& format) {
  Columns columns;
  columns.count = header.size();
  if (!format.rate) {
    const bool by_rule = format.time_column.empty();
    columns.time =
        mappedColumn(header, by_rule ? "time_s" : format.time_column, by_rule ? "" : format.time_unit, kTimeUnits);
  }
  columns.displacement =
      findQuantity(header, "displacement", format.displacement_column, format.displacement_unit, kDisplacementUnits);
  if (!columns.displacement.found()) {
    throw std::runtime_error(
        fmt::format("no column of displacement, the header has {}; accepted: {}, or another name by --columns",
                    listed(header), join(namesWithUnits("displacement", kDisplacementUnits))));
  }
  columns.force = findQuantity(header, "force", format.force_column, format.force_unit, kForceUnits);
  columns.temperature = format.temperature_column.empty() ? namedColumn(header, "temperature_degC")
                                                          : requireColumn(header, format.temperature_column);
  return columns;
}

std::vector<std::string> notesOnIgnored(const std::vector<std::string>& header, const Columns& columns,
                                        const LogFormat& format) {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const bool read = i == columns.time.index || i == columns.displacement.index || i == columns.force.index ||
                      i == columns.temperature.index;
    if (!read) {
      notes.push_back(fmt::format("column {} is ignored", quoted(header[i])));
    }
  }
  for (const Column* column : {&columns.time, &columns.displacement, &columns.force}) {
    if (!column->assumed_unit.empty()) {
      notes.push_back(fmt::format("column {} is taken to be in {}; another unit by --unit", quoted(column->name),
                                  column->assumed_unit));
    }
  }
  noteUnusedUnit(notes, columns.displacement, "displacement", format.displacement_unit);
  noteUnusedUnit(notes, columns.force, "force", format.force_unit);
  return notes;
}

std::int64_t toStamp(long double time, const Column& column) {
  const long double seconds_per_unit = column.conversion(1.0);
  // A division, for 1 ms is a whole part of a second and not 0.001 in binary.
  const long double seconds =
      seconds_per_unit < 1.0L ? time / std::round(1.0L / seconds_per_unit) : time * seconds_per_unit;
  if (!(std::abs(seconds) <= kMaximumTime)) {
    throw std::runtime_error(fmt::format("{}: {:g} s is out of range; accepted: at most {:g} s", column.name,
                                         static_cast<double>(seconds), kMaximumTime));
  }
  return std::llroundl(seconds * 1e9L);
}

std::int64_t stampAtRate(std::size_t sample, double rate) {
  return std::llround(static_cast<double>(sample) * 1e9 / rate);
}

void requireIncrease(const std::vector<std::int64_t>& stamps, std::int64_t next, const Column& column) {
  if (!stamps.empty() && next <= stamps.back()) {
    throw std::runtime_error(
        fmt::format("{}: {} after {}; accepted: time that increases from row to row, by 1 ns at least", column.name,
                    formatStamp(next), formatStamp(stamps.back())));
  }
}

std::string formatStamp(std::int64_t stamp) {
  const std::int64_t magnitude = std::abs(stamp);
  return fmt::format("{}{}.{:09d}", stamp < 0 ? "-" : "", magnitude / 1000000000, magnitude % 1000000000);
}

std::string logName(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  return file.substr(0, file.find_last_of('.'));
}

}  // namespace rubber_suspension::log
