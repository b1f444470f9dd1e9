// Rules for the stamps of rows, the same for text and for files of whole columns: stamps that increase, a sampling rate
// in their place, a time that restarts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "log/log_columns.h"
#include "log/signals.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// A row in the units of the file; NaN: not measured.
struct SampleRow {
  std::size_t place = 0;              ///< line, or element of the columns, from 1
  std::optional<std::int64_t> stamp;  ///< [ns]; nullopt: not measured, or no column of time
  std::array<double, kSignals> value = {kNotMeasured, kNotMeasured, kNotMeasured};
  /// Why a value is missing, by quantity, for errors: "force_N: 'OL' is not a number".
  std::array<std::string, kQuantities.size()> unmeasured;
  std::array<bool, kSignals> faulty = {};  ///< the cell is neither a number nor empty
};

class SampleRules {
 public:
  /// `word`: name of a place, "line" or "element". The columns have to outlive the rules.
  SampleRules(const LogFormat& format, const Columns& columns, const char* word);

  /// Returns true if the time falls back to where it began, so that another log begins.
  bool restarts(const SampleRow& row) const;

  /// Returns true for a time at most three steps behind the last one: rows behind a repeated header then belong to the
  /// same log.
  bool continues(const std::optional<std::int64_t>& stamp) const;

  /// Adds a row, unless it repeats the preceding one or lacks its time; sets its stamp if the format gives a rate.
  /// Appends complete samples to the log. Throws RowError.
  void take(SampleRow& row, Log& to);

  /// Appends the remaining samples once all rows are added. Throws RowError for errors that only show then.
  void finish(Log& to);

  /// Returns notes on rows and stamps that were omitted, merged or replaced.
  std::vector<std::string> notes() const;

  LogExtent extent() const { return signals_.extent(); }

  /// Returns the rate of the stamps so far [Hz]; 0 if unknown.
  double rate() const;

 private:
  bool repeatsLast(const SampleRow& row) const;
  bool completesLast(const SampleRow& row) const;
  void compareWithRate(const SampleRow& row);
  double ownRate() const;
  [[noreturn]] void refuseStamps() const;

  LogFormat format_;
  const Columns& columns_;
  Signals signals_;
  const char* word_;
  std::size_t rows_ = 0;
  std::vector<std::int64_t> recent_;  // stamps, to suggest a rate if one does not increase
  std::int64_t first_stamp_ = 0;
  std::size_t stamped_ = 0;
  std::int64_t last_stamp_ = 0;
  std::array<double, kSignals> last_ = {};
  std::size_t merged_ = 0;
  std::size_t first_merged_ = 0;
  std::size_t own_stamps_ = 0;  // of a time column, beside a given rate
  std::size_t bad_stamps_ = 0;  // of these, not later than the one before
  std::int64_t first_own_ = 0;
  std::int64_t last_own_ = 0;
  std::size_t refused_place_ = 0;  // of a stamp that does not increase; 0: none
  std::int64_t refused_stamp_ = 0;
};

}  // namespace rubber_suspension::log
