// Finds time, displacement, force and temperature among the columns of a file, and converts their numbers to SI.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "log/column_name.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::log {

/// A column that is read: where it stands and what converts its numbers.
struct Column {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t index = kNone;
  std::string name;   ///< as in the file
  std::string label;  ///< the same with the unit of a row of units
  UnitConversion conversion{"1", "1"};
  double factor = 1.0;       ///< given by the user
  std::string assumed_unit;  ///< of a column whose unit neither its name nor the user gives; else empty
  bool tells_unit = true;    ///< false for a time whose unit neither the file nor the user tells: its text may

  bool found() const { return index != kNone; }
  bool isAt(std::size_t place) const { return found() && index == place; }

  /// A number of the file in SI units.
  double toSi(double number) const { return factor * conversion(number); }
};

struct Columns {
  std::size_t count = 0;  ///< number of columns in the header
  Column time;            ///< may be missing if the format gives a rate
  Column displacement;
  Column force;        ///< may be missing
  Column temperature;  ///< may be missing

  /// In the order of kQuantities.
  std::array<const Column*, 4> all() const { return {&time, &displacement, &force, &temperature}; }
  const Column& of(Quantity quantity) const { return *all()[static_cast<std::size_t>(quantity)]; }
};

/// Find the columns: those that the format names or numbers, then by name, then by unit where exactly one column has a
/// unit of that quantity. What is ambiguous is refused. Throws std::runtime_error with name and what is accepted.
Columns findColumns(const std::vector<ColumnName>& header, const LogFormat& format);

/// The column of time at a place, in the unit of the option or its own.
Column timeAt(const std::vector<ColumnName>& header, std::size_t place, const LogFormat& format);

/// Throws std::runtime_error for a column of time whose unit nothing tells; beside a rate it is left out.
void requireTimeUnit(Columns& columns, const LogFormat& format);

/// True where a row of names tells enough to be a header: the columns that the format names are there, and of the
/// others at least displacement and time, or any two.
bool looksLikeHeader(const std::vector<ColumnName>& header, const LogFormat& format);

/// True where displacement and time, or the format's rate, are there.
bool holdsLog(const std::vector<ColumnName>& header, const LogFormat& format);

/// Origin of the units of these columns.
UnitsAre unitsOf(const Columns& columns, const LogFormat& format);

/// A note for every column, and every unit of the format, that is not used.
std::vector<std::string> notesOnIgnored(const std::vector<ColumnName>& header, const Columns& columns,
                                        const LogFormat& format);

/// True where all columns that are read have the names that this package writes.
bool areCanonical(const Columns& columns);

/// Number of samples of a log, with first and last stamp [ns].
struct LogExtent {
  std::size_t samples;
  std::int64_t first_stamp;
  std::int64_t last_stamp;
};

/// The column taken for each quantity: "time from 'Zeit [s]', displacement from 'Weg [mm]', 1000 Hz".
std::string describeColumns(const Columns& columns, const LogExtent& extent);

/// The stamp [ns] of a time in the unit of its column. Throws std::runtime_error where it is out of range.
std::int64_t toStamp(long double time, const Column& column);

/// The stamp [ns] of a sample of a log without time column.
std::int64_t stampAtRate(std::size_t sample, double rate);

/// A stamp [ns] in seconds, exactly.
std::string formatStamp(std::int64_t stamp);

/// The number that digits alone are, at most so many; 0 for other text.
std::size_t wholeNumber(const std::string& text, std::size_t most = 5);

/// The file's name without folder and extension.
std::string logName(const std::string& path);

}  // namespace rubber_suspension::log
