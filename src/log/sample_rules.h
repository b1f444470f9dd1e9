// Decides for the rows of a file whether the time increases, restarts, or is replaced by a sampling rate.
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

/// A row with values in the units of the file; NaN if not measured.
struct SampleRow {
  std::size_t place = 0;              ///< line number, or index in the columns, counted from 1
  std::optional<std::int64_t> stamp;  ///< [ns]; nullopt if there is no column of time or the time is missing
  std::array<double, kSignals> value = {kNotMeasured, kNotMeasured, kNotMeasured};
  /// Reason why a value is missing, for each quantity, for errors: "force_N: 'OL' is not a number".
  std::array<std::string, kQuantities.size()> unmeasured;
  std::array<bool, kSignals> faulty = {};  ///< true if the cell is neither a number nor empty
};

class SampleRules {
 public:
  /// `word` is "line" or "element" and precedes positions in errors. The columns must outlive this object.
  SampleRules(const LogFormat& format, const Columns& columns, const char* word);

  /// Returns true if the time falls back to where it began, which means that another log begins.
  bool restarts(const SampleRow& row) const;

  /// Returns true for a time at most three steps after the last one. Rows below a repeated header then continue the
  /// log.
  bool continues(const std::optional<std::int64_t>& stamp) const;

  /// Adds a row and appends complete samples to the log. Sets the stamp of the row if the format gives a rate. A row
  /// that repeats the preceding one, or has no time, is omitted. Throws RowError.
  void take(SampleRow& row, Log& to);

  /// Appends the remaining samples after the last row. Throws RowError for errors that become apparent only then.
  void finish(Log& to);

  /// Returns notes on rows that were omitted and on stamps that were replaced.
  std::vector<std::string> notes() const;

  LogExtent extent() const { return signals_.extent(); }

  /// Returns the sampling rate of the latest stamps [Hz]; 0 if unknown.
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
  std::vector<std::int64_t> recent_;  // latest stamps, from which a rate is suggested if the time does not increase
  std::int64_t first_stamp_ = 0;
  std::size_t stamped_ = 0;
  std::int64_t last_stamp_ = 0;
  std::array<double, kSignals> last_ = {};
  std::size_t merged_ = 0;
  std::size_t first_merged_ = 0;
  std::size_t own_stamps_ = 0;  // number of stamps in the file that a given rate replaces
  std::size_t bad_stamps_ = 0;  // number of these stamps that are not later than the one before
  std::int64_t first_own_ = 0;
  std::int64_t last_own_ = 0;
  std::size_t refused_place_ = 0;  // position of a stamp that does not increase; 0: none
  std::int64_t refused_stamp_ = 0;
};

}  // namespace rubber_suspension::log
