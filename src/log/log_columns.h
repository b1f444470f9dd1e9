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

/// A column that is to be read: its index, and the conversion of its numbers to SI units.
struct Column {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t index = kNone;
  std::string name;   ///< name as in the file
  std::string label;  ///< name with its unit, also if the unit stands in a row of units
  UnitConversion conversion{"1", "1"};
  double factor = 1.0;       ///< factor given by the user
  std::string assumed_unit;  ///< unit assumed if neither the file nor the user states one; otherwise empty
  bool tells_unit = true;    ///< false if neither the file nor the user states the unit

  bool found() const { return index != kNone; }
  bool isAt(std::size_t place) const { return found() && index == place; }

  /// Returns a number of the file in SI units.
  double toSi(double number) const { return factor * conversion(number); }
};

struct Columns {
  std::size_t count = 0;  ///< number of columns in the header
  Column time;            ///< may be missing if the format gives a sampling rate
  Column displacement;
  Column force;        ///< may be missing
  Column temperature;  ///< may be missing

  std::array<const Column*, 4> all() const { return {&time, &displacement, &force, &temperature}; }
  const Column& of(Quantity quantity) const { return *all()[static_cast<std::size_t>(quantity)]; }
};

/// Finds the column of each quantity. It is the column that the format gives by name or number, or else the column that
/// has a name of the quantity, or else the only column with a unit of the quantity. Throws std::runtime_error if a
/// column is missing or ambiguous. The error states the names and what is accepted.
Columns findColumns(const std::vector<ColumnName>& header, const LogFormat& format);

/// Returns the column at an index as the column of time. Its unit is that of --unit, or else that of the file.
Column timeAt(const std::vector<ColumnName>& header, std::size_t place, const LogFormat& format);

/// If the unit of time is unknown, throws std::runtime_error. If the format gives a rate, discards the column instead.
void requireTimeUnit(Columns& columns, const LogFormat& format);

/// Returns true if a row of names may be a header: it contains all columns that the format names, and either the
/// columns that a log needs or any two quantities.
bool looksLikeHeader(const std::vector<ColumnName>& header, const LogFormat& format);

/// Returns true if the header has the columns that the format names, a displacement, and a time unless a rate is given.
bool holdsLog(const std::vector<ColumnName>& header, const LogFormat& format);

UnitsAre unitsOf(const Columns& columns, const LogFormat& format);

/// Returns notes on columns that are ignored, on units that are assumed, and on units that --unit replaces.
std::vector<std::string> notesOnIgnored(const std::vector<ColumnName>& header, const Columns& columns,
                                        const LogFormat& format);

/// Returns true if all columns that are read have names as this package writes them, and factors of 1.
bool areCanonical(const Columns& columns);

/// The number of samples of a log, and its first and last stamp [ns].
struct LogExtent {
  std::size_t samples;
  std::int64_t first_stamp;
  std::int64_t last_stamp;
};

/// Returns a description of the columns: "time from 'Zeit [s]', displacement from 'Weg [mm]', 1000 Hz".
std::string describeColumns(const Columns& columns, const LogExtent& extent);

/// Converts a time in the unit of its column to a stamp [ns]. Throws std::runtime_error if it is out of range.
std::int64_t toStamp(long double time, const Column& column);

/// Returns the stamp [ns] of a sample at a sampling rate [Hz].
std::int64_t stampAtRate(std::size_t sample, double rate);

/// Converts a stamp [ns] to an exact decimal number of seconds.
std::string formatStamp(std::int64_t stamp);

/// Returns the whole number that the text consists of; 0 if it contains other characters or more than `most` digits.
std::size_t wholeNumber(const std::string& text, std::size_t most = 5);

std::string logName(const std::string& path);

}  // namespace rubber_suspension::log
