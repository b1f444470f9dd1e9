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

/// A column that is read: its place, and the conversion of its numbers.
struct Column {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t index = kNone;
  std::string name;   ///< as in the file
  std::string label;  ///< name with the unit of a row of units
  UnitConversion conversion{"1", "1"};
  double factor = 1.0;       ///< given by the user
  std::string assumed_unit;  ///< assumed because neither file nor user states a unit; else empty
  bool tells_unit = true;    ///< false if neither file nor user states the unit; the text of a time may show it

  bool found() const { return index != kNone; }
  bool isAt(std::size_t place) const { return found() && index == place; }

  /// Returns a number of the file in SI units.
  double toSi(double number) const { return factor * conversion(number); }
};

struct Columns {
  std::size_t count = 0;  ///< number of columns in the header
  Column time;            ///< may be missing if the format gives a rate
  Column displacement;
  Column force;        ///< may be missing
  Column temperature;  ///< may be missing

  /// Returns the columns in the order of kQuantities.
  std::array<const Column*, 4> all() const { return {&time, &displacement, &force, &temperature}; }
  const Column& of(Quantity quantity) const { return *all()[static_cast<std::size_t>(quantity)]; }
};

/// Finds the columns that the format names or numbers, then others by name, then by unit if exactly one column has a
/// unit of that quantity. Throws std::runtime_error for missing and ambiguous columns, with name and what is accepted.
Columns findColumns(const std::vector<ColumnName>& header, const LogFormat& format);

/// Returns the column of time at a place, in the unit of the option or its own.
Column timeAt(const std::vector<ColumnName>& header, std::size_t place, const LogFormat& format);

/// Throws std::runtime_error if the unit of time is unknown; if the format gives a rate, discards the column instead.
void requireTimeUnit(Columns& columns, const LogFormat& format);

/// Returns true if a row of names may be a header: it has the columns that the format names, and at least those that a
/// log needs, or any two.
bool looksLikeHeader(const std::vector<ColumnName>& header, const LogFormat& format);

/// Returns true if the columns that the format names, displacement, and time or a rate are there.
bool holdsLog(const std::vector<ColumnName>& header, const LogFormat& format);

/// Returns the origin of the units of these columns.
UnitsAre unitsOf(const Columns& columns, const LogFormat& format);

/// Returns notes on columns that are ignored, and on units that are assumed or replaced by the format.
std::vector<std::string> notesOnIgnored(const std::vector<ColumnName>& header, const Columns& columns,
                                        const LogFormat& format);

/// Returns true if all columns that are read have the names that this package writes, and no factor.
bool areCanonical(const Columns& columns);

/// Number of samples of a log, with first and last stamp [ns].
struct LogExtent {
  std::size_t samples;
  std::int64_t first_stamp;
  std::int64_t last_stamp;
};

/// Describes the column of each quantity: "time from 'Zeit [s]', displacement from 'Weg [mm]', 1000 Hz".
std::string describeColumns(const Columns& columns, const LogExtent& extent);

/// Returns the stamp [ns] of a time in the unit of its column. Throws std::runtime_error if it is out of range.
std::int64_t toStamp(long double time, const Column& column);

/// Returns the stamp [ns] of a sample at a sampling rate [Hz].
std::int64_t stampAtRate(std::size_t sample, double rate);

/// Returns a stamp [ns] in seconds, exactly.
std::string formatStamp(std::int64_t stamp);

/// Returns the number of a text of digits alone, at most `most` of them; 0 for other text.
std::size_t wholeNumber(const std::string& text, std::size_t most = 5);

/// Returns the file's name without folder and extension.
std::string logName(const std::string& path);

}  // namespace rubber_suspension::log
