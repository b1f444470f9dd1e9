// A recorded log: displacement and force over time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rubber_suspension::log {

class NewFile;

/// Origin of the units of displacement and force.
enum class UnitsAre {
  named,     ///< by the file or the user
  assumed,   ///< SI for at least one of them, because neither file nor user names its unit
  accepted,  ///< confirmed by the user: not checked
};

/// A log in SI units; all vectors that are not empty have the same length.
struct Log {
  std::string name;                  ///< file name without folder and extension
  std::vector<std::int64_t> stamp;   ///< [ns]
  std::vector<double> displacement;  ///< [m]
  std::vector<double> force;         ///< measured [N]; empty if the log has none
  std::vector<double> temperature;   ///< [degC]; empty if the log has none
  /// 1 where the force was measured, 0 where it is interpolated and not compared; empty: measured throughout.
  std::vector<double> counts;
  std::vector<double> across;      ///< displacement perpendicular to this one, on the same radius [m]; empty: unknown
  std::vector<std::string> notes;  ///< what was ignored and why
  UnitsAre units = UnitsAre::named;

  std::size_t size() const { return stamp.size(); }
  double time(std::size_t i) const { return static_cast<double>(stamp[i]) * 1e-9; }  ///< [s]
  /// Returns the time from one sample to another [s].
  double duration(std::size_t first, std::size_t last) const {
    return static_cast<double>(stamp[last] - stamp[first]) * 1e-9;
  }
};

/// Reports why a log is refused. what() is one line that names the place in the file and the reason.
class LogError : public std::runtime_error {
 public:
  explicit LogError(const std::string& message);
};

/// The LogFormat::segment that requests all segments of a file, each as a log of its own.
constexpr std::size_t kAllSegments = static_cast<std::size_t>(-1);

/// Format of a file as far as the file does not state it. A column is named as in the file, with or without its unit,
/// or by its number from 1.
struct LogFormat {
  struct Channel {
    std::string column;   ///< empty: found by name or unit
    std::string unit;     ///< empty: that of the file
    double factor = 1.0;  ///< multiplies the numbers of the file
    char decimal = '\0';  ///< decimal mark of this column; '\0': that of the format
  };

  std::array<Channel, 4> of;     ///< time, displacement, force, temperature
  std::optional<double> rate;    ///< sampling rate [Hz] that replaces the stamps; the first sample is at 0 s
  char decimal = '\0';           ///< decimal mark of text, '.' or ','; '\0': detected from the numbers
  std::size_t segment = 0;       ///< number from 1 if a file has several logs, or kAllSegments; 0: it has one
  bool turns = false;            ///< the displacement is an angle [rad] and the force a moment [N m]
  std::optional<double> bridge;  ///< longest time without numbers that is bridged [s]; nullopt: 0.5 s, and only if 99
                                 ///< of 100 rows have numbers
  bool large = false;            ///< a packed file may unpack to more than a hundred times its size
  /// Code of the file for a missing value; NaN: none; nullopt: a repeated number far outside the range of the others.
  std::optional<double> sentinel;
  bool by_receipt = false;    ///< times of messages in a bag are those of their receipt
  bool accept_units = false;  ///< no check questions the units
};

/// Returns the format that options of a command describe: `--columns displacement=D force=-0.001*F`, or the quantities
/// in the order of the columns, `--columns time displacement force`; `--unit force=kN displacement=mm`, separated by
/// blanks; `--sampling-rate 1000` (rate 0: not given). Throws std::invalid_argument that names option, value and what
/// is accepted.
LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate);

/// Returns such a format with `--decimal ,` or `--decimal force=,`, `--segment 2` or `--segment all`, `--bridge
/// SECONDS`, `--sentinel none` or `--sentinel -9999`, and `--clock receipt`; empty text, `bridge` less than 0: not
/// given. Throws likewise.
LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate,
                        const std::string& decimal, const std::string& segment, double bridge,
                        const std::string& sentinel = "", const std::string& clock = "");

/// Bounds on a CSV log; a file beyond them is refused.
constexpr std::size_t kMaximumLogRows = 20000000;  // 5.5 hours at 1 kHz
constexpr std::size_t kMaximumSegments = 10000;
constexpr std::size_t kMaximumLogLine = 64 * 1024;  // bytes

/// Reads a log from text. The canonical form, which this package writes and reads fastest, is a header with columns
/// time_s, displacement_<m|mm|um>, force_<N|kN|MN> (optional), temperature_degC (optional), then one row per sample,
/// separated by commas. Other forms are read with a note on how they were interpreted: plain names in English and
/// German with a unit behind them or in a row of units; columns of other names if exactly one has a unit of length, of
/// force, of time; any unit of UDUNITS-2; times as a clock or a calendar shows them; semicolons, tabs or blanks as
/// separators; decimal commas; thousands separators; quotes; comments and a preamble; UTF-8, UTF-16, Latin-1; LF,
/// CRLF, CR; gzip (docs/logs.md). Further columns, rows that repeat the preceding one, and a small share of rows
/// without a number are omitted with a note. Times are rounded to nanoseconds. Throws LogError with file, line and
/// reason for columns and marks that are ambiguous, with the option that resolves them; a field that is no number; a
/// row of another length; time that does not increase; several logs in one file unless the format selects one; fewer
/// than two rows.
Log readCsvLog(const std::string& path, const LogFormat& format = {});

/// Reads a log in the format that its content shows: MATLAB (level 4 by the extension .mat), HDF5, RPC III, otherwise
/// text. Throws LogError, also if the format requests all segments and there are several.
Log readLog(const std::string& path, const LogFormat& format = {});

/// Reads the log of a file, or each segment if the format requests all. Throws LogError.
std::vector<Log> readLogs(const std::string& path, const LogFormat& format = {});

/// Checks a log from any source: lengths agree, time increases, all values are finite, there are at least two samples.
/// Throws LogError that names log, sample and value.
void checkLog(const Log& log);

/// Parts of checkLog() for callers that read a log block by block: lengths, and samples [first, first + count).
void checkLengths(const Log& log);
void checkSamples(const Log& log, std::size_t first, std::size_t count);

/// Writes `time_s,displacement_m` and, if requested, `force_N` row by row: time as exact decimal, the others with 17
/// digits, so that reading returns the same bits. The file is written under a temporary name and renamed by close();
/// without close() it is removed. All calls throw LogError.
class LogCsvWriter {
 public:
  LogCsvWriter(const std::string& path, bool with_force);
  ~LogCsvWriter();

  void append(std::int64_t stamp, double displacement, double force = 0.0);
  void close();

 private:
  void fail() const;

  std::string path_;
  bool with_force_;
  std::unique_ptr<NewFile> new_file_;
  std::ofstream file_;
};

/// Writes `time_s,displacement_m,force_N` of a log with other forces, as LogCsvWriter does. Throws LogError.
void writeForceCsv(const std::string& path, const Log& log, const std::vector<double>& force);

/// Writes `time_s,displacement_m` and any measured force as `force_N`, as LogCsvWriter does. Throws LogError.
void writeLogCsv(const std::string& path, const Log& log);

}  // namespace rubber_suspension::log
