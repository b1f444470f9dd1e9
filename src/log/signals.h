// Merges displacement, force and temperature, which may be sampled at different times, to a log. The log has the stamps
// of the displacement; the other signals are interpolated. At most some 260,000 rows are kept in memory.
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

/// The signals of a log: kQuantities without the time.
constexpr std::size_t kSignals = 3;
constexpr std::size_t kMotion = 0;
constexpr std::size_t kForce = 1;
constexpr std::size_t kTemperature = 2;

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// An error in a row of a file, which is not always the row that was read last.
class RowError : public std::runtime_error {
 public:
  RowError(std::size_t row, const std::string& reason) : std::runtime_error(reason), row_(row) {}
  std::size_t row() const { return row_; }

 private:
  std::size_t row_;
};

/// The values at one time in the units of the file; NaN if not measured.
struct SignalRow {
  std::int64_t stamp = 0;  ///< [ns]
  std::size_t place = 0;   ///< line number, or index in the columns, counted from 1
  std::array<double, kSignals> value = {kNotMeasured, kNotMeasured, kNotMeasured};
  std::array<bool, kSignals> faulty = {};  ///< true if the cell is neither a number nor empty
  bool timeless = false;
};

class Signals {
 public:
  /// `word` is "line" or "element" and precedes positions in errors. The columns must outlive this object.
  Signals(const LogFormat& format, const Columns& columns, const char* word);

  /// Adds the next row and appends complete samples to the log. The stamp must not be earlier than that of the last
  /// row. `reason` states for notes and errors why a value is missing. Throws RowError.
  void add(const SignalRow& row, const std::array<std::string, kSignals>& reason, Log& to);

  /// Counts a row that is omitted because it has no time.
  void addTimeless(std::size_t place, const std::string& reason, Log& to);

  /// Appends the remaining samples after the last row. Throws RowError for errors that become apparent only then.
  void finish(Log& to);

  std::vector<std::string> notes() const;

  LogExtent extent() const { return {handed_out_, first_stamp_, last_stamp_}; }

 private:
  struct Sample {
    std::int64_t stamp = 0;
    std::array<double, kSignals> value = {};
    bool counts = true;
  };

  // A number that the file writes for missing values.
  struct Sentinel {
    double value = 0.0;
    double low = 0.0;  // range of the other values
    double high = 0.0;
    std::vector<std::size_t> places;  // positions of the first few cells with this number
    std::size_t cells = 0;
  };

  struct Signal {
    bool there = false;
    std::size_t rows = 0;         // number of rows with a value
    std::size_t first_place = 0;  // position of the first row without a value
    std::string first_reason;
    std::int64_t step = 0;  // median step between the samples of this signal [ns]
    std::vector<Sentinel> sentinels;
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    std::vector<Sentinel> suspects;  // values far out of range that occurred once
    // The variables below are the state of merge().
    bool begun = false;
    std::int64_t last_stamp = 0;
    double last_value = 0.0;
    bool last_shared = false;  // true if the displacement has the same stamp
    std::size_t next = 0;      // index of the first sample that waits for this signal
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
  std::vector<SignalRow> ahead_;  // first rows, from which steps and codes of missing values are determined
  bool settled_ = false;
  std::size_t rows_ = 0;
  std::deque<Sample> pending_;
  std::size_t passed_ = 0;  // number of samples before the pending ones
  std::size_t handed_out_ = 0;
  std::int64_t first_stamp_ = 0;
  std::int64_t last_stamp_ = 0;
  std::size_t compared_ = 0;
  // Rows since the last displacement.
  std::size_t gap_rows_ = 0;
  std::size_t gap_faults_ = 0;
  std::size_t gap_place_ = 0;
  // Rows without a displacement that are omitted: in a gap longer than kLongestSteps steps, or with faulty cells.
  std::size_t lost_rows_ = 0;
  std::size_t longest_place_ = 0;
  double longest_gap_ = 0.0;  // [s]
  std::size_t timeless_ = 0;
  std::size_t first_timeless_ = 0;
  std::string timeless_reason_;
};

}  // namespace rubber_suspension::log
