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
  assumed,   ///< SI, because neither names that of the one or of the other
  accepted,  ///< confirmed by the user: not checked
};

/// A log in SI units; all vectors that are not empty have the same length.
struct Log {
  std::string name;                  ///< file name without folder and extension
  std::vector<std::int64_t> stamp;   ///< [ns]
  std::vector<double> displacement;  ///< [m]
  std::vector<double> force;         ///< measured [N]; empty if the log has none
  std::vector<double> temperature;   ///< [degC]; empty if the log has none
  /// 1 where the force was measured, 0 where it is interpolated and compared with nothing; empty: measured throughout.
  std::vector<double> counts;
  std::vector<double> across;      ///< displacement that shares a radius with this one [m]; empty: none is known
  std::vector<std::string> notes;  ///< what was ignored and why
  UnitsAre units = UnitsAre::named;

  std::size_t size() const { return stamp.size(); }
  double time(std::size_t i) const { return static_cast<double>(stamp[i]) * 1e-9; }  ///< [s]
  /// From one sample to another [s].
  double duration(std::size_t first, std::size_t last) const {
    return static_cast<double>(stamp[last] - stamp[first]) * 1e-9;
  }
};

/// A log that was refused. what() is one line: file:line and reason.
class LogError : public std::runtime_error {
 public:
  explicit LogError(const std::string& message);
};

/// All segments of a file, each as a log of its own.
constexpr std::size_t kAllSegments = static_cast<std::size_t>(-1);

/// Format of a file that does not state it itself. A column is named as in the file, with or without its unit, or by
/// its number from 1.
struct LogFormat {
  struct Channel {
    std::string column;   ///< empty: by name or unit
    std::string unit;     ///< empty: that of the file
    double factor = 1.0;  ///< times what the file has
    char decimal = '\0';  ///< its own decimal mark; '\0': that of the format
  };

  std::array<Channel, 4> of;     ///< time, displacement, force, temperature
  std::optional<double> rate;    ///< sampling rate [Hz], in place of stamps; the first sample is at 0 s
  char decimal = '\0';           ///< decimal mark of text, '.' or ','; '\0': detected from the numbers
  std::size_t segment = 0;       ///< number from 1 if a file has several logs, or kAllSegments; 0: it has one
  bool turns = false;            ///< the displacement is an angle [rad] and the force a moment [N m]
  std::optional<double> bridge;  ///< longest time without a number that is passed over [s]; nothing: 0.5 s, and only
                                 ///< where 99 of 100 rows have their numbers
  bool large = false;            ///< a packed file may unpack to more than a hundred times its size
  /// Code of the file for a missing value; NaN: there is none; nullopt: a repeated number far beyond the others is one.
  std::optional<double> sentinel;
  bool by_receipt = false;    ///< messages of a bag have the times of their receipt
  bool accept_units = false;  ///< no check shall doubt the units
};

/// The format that options of a command describe: `--columns displacement=D force=-0.001*F`, or the quantities in the
/// order of the columns, `--columns time displacement force`; `--unit force=kN displacement=mm`, separated by blanks;
/// `--sampling-rate 1000` (rate 0: not given). Throws std::invalid_argument that names option, value and what is
/// accepted.
LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate);

/// Makes a format with `--decimal ,` or `--decimal force=,` as well, `--segment 2` or `--segment all`, `--bridge
/// SECONDS`, `--sentinel none` or `--sentinel -9999`, and `--clock receipt`; empty, or less than 0: not given.
LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate,
                        const std::string& decimal, const std::string& segment, double bridge,
                        const std::string& sentinel = "", const std::string& clock = "");

/// Bounds on a CSV log; a file beyond them is refused.
constexpr std::size_t kMaximumLogRows = 20000000;  // 5.5 hours at 1 kHz
constexpr std::size_t kMaximumSegments = 10000;
constexpr std::size_t kMaximumLogLine = 64 * 1024;  // bytes

/// Reads a log from text. Canonical, and read fastest, is what this package writes: a header with columns time_s,
/// displacement_<m|mm|um>, force_<N|kN|MN> (optional), temperature_degC (optional), then one row per sample, separated
/// by commas. Read as well, with a note of what was taken for what: plain names in English and German with a unit
/// behind them or in a row of units, columns of other names where exactly one has a unit of length, of force, of time;
/// any unit of UDUNITS-2; times as a clock or a calendar shows them; separators semicolon, tab, blanks; decimal commas;
/// marks between thousands; quotes; comments and a preamble; UTF-8, UTF-16, Latin-1; LF, CRLF, CR; gzip (docs/logs.md).
/// Further columns are ignored with a note; rows without a number are left out where little is lost, and rows that
/// repeat the one before, with a note. Refused, with file, line and reason: columns and marks that are ambiguous, with
/// the option that settles it; a field that is no number; a row of another length; time that does not increase; several
/// logs in one file unless the format says which; less than two rows. Time becomes the nearest integer nanosecond.
/// Throws LogError.
Log readCsvLog(const std::string& path, const LogFormat& format = {});

/// Reads a log by its content: MATLAB (level 4 by the extension .mat), HDF5, otherwise text. Throws LogError, also
/// where the format asks for all segments and there is more than one.
Log readLog(const std::string& path, const LogFormat& format = {});

/// The logs of a file: one, or each segment where the format asks for all. Throws LogError.
std::vector<Log> readLogs(const std::string& path, const LogFormat& format = {});

/// Checks a log from any source: lengths agree, time increases, all is finite, at least two samples.
/// Throws LogError that names log, sample and value.
void checkLog(const Log& log);

/// checkLog() in pieces, for callers that iterate over a log: first its lengths, then its samples from `first` on.
void checkLengths(const Log& log);
void checkSamples(const Log& log, std::size_t first, std::size_t count);

/// Writes `time_s,displacement_m` and, if wanted, `force_N`, piece by piece; time as exact decimal, the others with 17
/// digits: all reads back bit by bit. The file is written under a temporary name and renamed in close(); without that
/// call it is removed. All calls throw LogError.
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

/// Writes `time_s,displacement_m,force_N`; time as exact decimal, the others with 17 digits: all reads back bit by bit.
/// Throws LogError.
void writeForceCsv(const std::string& path, const Log& log, const std::vector<double>& force);

/// Writes `time_s,displacement_m` and, if the log has a measured force, `force_N`, as exactly. Throws LogError.
void writeLogCsv(const std::string& path, const Log& log);

}  // namespace rubber_suspension::log
