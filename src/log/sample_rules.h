// The rules by which rows of a file become samples of a log, the same for text and for files of whole columns: stamps
// that increase, a sampling rate in their place, values that were not measured.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "log/log_columns.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// The error of a row of a file, which need not be the one that was read last.
class RowError : public std::runtime_error {
 public:
  RowError(std::size_t row, const std::string& reason) : std::runtime_error(reason), row_(row) {}
  std::size_t row() const { return row_; }

 private:
  std::size_t row_;
};

/// A row in SI units; not a number: not measured.
struct SampleRow {
  std::size_t place = 0;              ///< line, or element of the columns, from 1
  std::optional<std::int64_t> stamp;  ///< [ns]; nothing: not measured, or no column of time
  double displacement = 0.0;          ///< [m]
  double force = 0.0;                 ///< [N]
  double temperature = 0.0;           ///< [degC]
  std::string unmeasured;             ///< why a value is missing, for errors: "force_N: 'OL' is not a number"
};

class SampleRules {
 public:
  /// `word`: what a place is called, "line" or "element". The columns have to outlive the rules.
  SampleRules(const LogFormat& format, const Columns& columns, const char* word);

  /// Appends the row to a log, unless it repeats the one before or lacks a value; gives it its stamp where a rate is
  /// given. Throws RowError.
  void take(SampleRow& row, Log& to);

  /// Once all rows are taken: throws RowError for what only shows then.
  void finish() const;

  /// Notes on what was left out, merged or replaced.
  std::vector<std::string> notes() const;

  LogExtent extent() const { return {kept_, first_stamp_, last_.stamp.value_or(0)}; }

 private:
  void keep(const SampleRow& row, Log& to);
  void checkGap(const SampleRow& row) const;
  bool lacksValue(const SampleRow& row) const;
  bool repeatsLast(const SampleRow& row) const;
  void compareWithRate(const SampleRow& row);
  double ownRate() const;
  [[noreturn]] void refuseStamps() const;

  LogFormat format_;
  const Columns& columns_;
  const char* word_;
  std::size_t rows_ = 0;
  std::size_t kept_ = 0;
  std::int64_t first_stamp_ = 0;
  SampleRow last_;  // kept
  std::size_t merged_ = 0;
  std::size_t first_merged_ = 0;
  std::size_t missing_ = 0;
  SampleRow first_missing_;
  std::optional<SampleRow> gap_;  // its first row, since the sample that was kept last
  double longest_gap_ = 0.0;      // that was bridged [s]
  std::size_t own_stamps_ = 0;    // of a time column, beside a given rate
  std::size_t bad_stamps_ = 0;    // of these, not later than the one before
  std::int64_t first_own_ = 0;
  std::int64_t last_own_ = 0;
  std::vector<std::int64_t> collected_;  // behind a stamp that does not increase, to tell the rate
  SampleRow refused_;
};

}  // namespace rubber_suspension::log
