// Merges displacement, force and temperature, which may have clocks of their own, to a log: the displacement sets its
// stamps, the others are interpolated. Memory: some 260,000 rows, whatever the length.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "log/log_columns.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// The signals of a log, in the order of their quantities without the time.
constexpr std::size_t kSignals = 3;
constexpr std::size_t kMotion = 0;
constexpr std::size_t kForce = 1;
constexpr std::size_t kTemperature = 2;

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// An error in a row of a file, which need not be the one that was read last.
class RowError : public std::runtime_error {
 public:
  RowError(std::size_t row, const std::string& reason) : std::runtime_error(reason), row_(row) {}
  std::size_t row() const { return row_; }

 private:
  std::size_t row_;
};

/// Values of one time, as in the file; NaN: not measured.
struct SignalRow {
  std::int64_t stamp = 0;  ///< [ns]
  std::size_t place = 0;   ///< line, or element of the columns, from 1
  std::array<double, kSignals> value = {kNotMeasured, kNotMeasured, kNotMeasured};
  std::array<bool, kSignals> faulty = {};  ///< the cell is neither a number nor empty
  bool timeless = false;
};

class Signals {
 public:
  /// `word`: name of a place, "line" or "element". The columns have to outlive the signals.
  Signals(const LogFormat& format, const Columns& columns, const char* word);

  /// Adds the next row, whose stamp is not before that of the last one; `reason` is why a value is missing, for notes
  /// and errors. Appends complete samples to the log. Throws RowError.
  void add(const SignalRow& row, const std::array<std::string, kSignals>& reason, Log& to);

  /// Counts a row without a time, which is omitted.
  void addTimeless(std::size_t place, const std::string& reason, Log& to);

  /// Appends the remaining samples once all rows are added. Throws RowError for errors that only show then.
  void finish(Log& to);

  std::vector<std::string> notes() const;

  LogExtent extent() const { return {handed_out_, first_stamp_, last_stamp_}; }

 private:
  struct Sample {
    std::int64_t stamp = 0;
    std::array<double, kSignals> value = {};
    bool counts = true;
  };

  // A code of missing values.
  struct Sentinel {
    double value = 0.0;
    double low = 0.0;  // range of the other values
    double high = 0.0;
    std::vector<std::size_t> places;  // the first cells
    std::size_t cells = 0;
  };

  struct Signal {
    bool there = false;
    std::size_t rows = 0;         // with a number
    std::size_t first_place = 0;  // first row without a number
    std::string first_reason;
    std::int64_t step = 0;  // median between its own samples [ns]
    std::vector<Sentinel> sentinels;
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    std::vector<Sentinel> suspects;  // beyond the range, seen once
    // State of the merge:
    bool begun = false;
    std::int64_t last_stamp = 0;
    double last_value = 0.0;
    bool last_shared = false;  // its stamp is that of a displacement
    std::size_t next = 0;      // first sample that waits for its value
  };

  void settle(Log& to);
  void findSentinels(std::size_t signal);
  void measureSteps(std::size_t signal);
  void dropSentinels(SignalRow& row);
  void watchRange(std::size_t signal, const SignalRow& row);
  void merge(SignalRow row, Log& to);
  void addSample(const SignalRow& row);
  void addMissing(const SignalRow& row, bool faulty);
  void arrive(std::size_t signal, const SignalRow& row);
  void handOut(Log& to, bool all);
  void append(const Sample& sample, Log& to);
  void refuseGaps() const;
  std::string advice() const;
  std::string sentinelText(std::size_t signal, const Sentinel& sentinel) const;
  void noteSignal(std::size_t signal, std::vector<std::string>& notes) const;
  const Column& columnOf(std::size_t signal) const;

  LogFormat format_;
  const Columns& columns_;
  const char* word_;
  std::array<Signal, kSignals> signals_;
  std::vector<SignalRow> ahead_;  // rows from which steps and sentinels are found
  bool settled_ = false;
  std::size_t rows_ = 0;
  std::deque<Sample> pending_;
  std::size_t passed_ = 0;  // samples before the pending ones
  std::size_t handed_out_ = 0;
  std::int64_t first_stamp_ = 0;
  std::int64_t last_stamp_ = 0;
  std::size_t compared_ = 0;
  // Rows without a displacement since its last sample.
  std::size_t gap_rows_ = 0;
  std::size_t gap_faults_ = 0;
  std::size_t gap_place_ = 0;
  // Rows in gaps that are longer than the steps of the displacement's clock.
  std::size_t lost_rows_ = 0;
  std::size_t longest_place_ = 0;
  double longest_gap_ = 0.0;  // [s]
  std::size_t timeless_ = 0;
  std::size_t first_timeless_ = 0;
  std::string timeless_reason_;
};

}  // namespace rubber_suspension::log
