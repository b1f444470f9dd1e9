// A recorded log: displacement and force as functions of time.
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

/// States where the units of displacement and force come from.
enum class UnitsAre {
  named,     ///< the file or the user names the units of displacement and force
  assumed,   ///< at least one unit is assumed to be SI, because neither the file nor the user names it
  accepted,  ///< the user has confirmed the units, so that they are not checked
};

/// A log in SI units. All vectors that are not empty have the same length.
struct Log {
  std::string name;                  ///< name of the file without folder and extension
  std::vector<std::int64_t> stamp;   ///< [ns]
  std::vector<double> displacement;  ///< [m]
  std::vector<double> force;         ///< measured force [N]; empty if the log has no force
  std::vector<double> temperature;   ///< temperature [degC]; empty if the log has no temperature
  /// 1 where the force was measured, 0 where it is interpolated and not compared. Empty: every force was measured.
  std::vector<double> counts;
  std::vector<double> across;      ///< displacement in the perpendicular radial direction [m]; empty if unknown
  std::vector<std::string> notes;  ///< statements about what was ignored and why
  UnitsAre units = UnitsAre::named;

  std::size_t size() const { return stamp.size(); }
  double time(std::size_t i) const { return static_cast<double>(stamp[i]) * 1e-9; }  ///< [s]
  /// Returns the time from sample `first` to sample `last` [s].
  double duration(std::size_t first, std::size_t last) const {
    return static_cast<double>(stamp[last] - stamp[first]) * 1e-9;
  }
};

/// Reports why a log is refused. what() returns one line that names the position in the file and the reason.
class LogError : public std::runtime_error {
 public:
  explicit LogError(const std::string& message);
};

/// Value of LogFormat::segment that requests all segments of a file. Each of them becomes a log of its own.
constexpr std::size_t kAllSegments = static_cast<std::size_t>(-1);

/// Describes what a file does not state about its own format. A column is given by its name in the file, with or
/// without the unit, or by its number, counted from 1.
struct LogFormat {
  struct Channel {
    std::string column;   ///< name or number of the column; empty: found by name or unit
    std::string unit;     ///< unit of the column; empty: the unit that the file states
    double factor = 1.0;  ///< the numbers of the file are multiplied by this factor
    char decimal = '\0';  ///< decimal mark of this column; '\0': LogFormat::decimal applies
  };

  std::array<Channel, 4> of;     ///< in this order: time, displacement, force, temperature
  std::optional<double> rate;    ///< sampling rate [Hz] that replaces the stamps; the first sample is then at 0 s
  char decimal = '\0';           ///< decimal mark of a text file, '.' or ','; '\0': detected from the numbers
  std::size_t segment = 0;       ///< segment to read, counted from 1, or kAllSegments; 0: the file must contain one log
  bool turns = false;            ///< true if the displacement is an angle [rad] and the force a moment [N m]
  std::optional<double> bridge;  ///< longest interval without numbers to bridge [s]; nullopt: 0.5 s, for 1 % of rows
  bool large = false;            ///< true if a packed file may expand to more than a hundred times its size
  /// Number that marks missing values. NaN: none does. nullopt: detected as a repeated value far outside all others.
  std::optional<double> sentinel;
  bool by_receipt = false;    ///< true if messages of a bag are given the time at which they were received
  bool accept_units = false;  ///< true if the units are not to be checked
};

/// Returns the format that these options of a command describe. `columns` are the values of `--columns displacement=D
/// force=-0.001*F`, or the quantities in the order of the columns, `--columns time displacement force`. `units` is the
/// value of `--unit "force=kN displacement=mm"`. `rate` is the value of `--sampling-rate`; 0 means that the option is
/// not given. Throws std::invalid_argument that names option, value and what is accepted.
LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate);

/// An overload that also takes the values of these options: `--decimal ,` or `--decimal force=,`, `--segment 2` or
/// `--segment all`, `--bridge SECONDS`, `--sentinel none` or `--sentinel -9999`, and `--clock receipt`. An empty text
/// or a negative `bridge` stands for an option that is not given. Throws std::invalid_argument as above.
LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate,
                        const std::string& decimal, const std::string& segment, double bridge,
                        const std::string& sentinel = "", const std::string& clock = "");

/// A CSV log that exceeds one of these limits is refused.
constexpr std::size_t kMaximumLogRows = 20000000;  // 5.5 hours at 1 kHz
constexpr std::size_t kMaximumSegments = 10000;
constexpr std::size_t kMaximumLogLine = 64 * 1024;  // bytes

/// Reads a log from text. The package writes logs in its canonical form, which is also the fastest to read: a header
/// with the columns time_s, displacement_<m|mm|um>, force_<N|kN|MN> (optional), temperature_degC (optional), then one
/// row per sample, with commas as separators. Other forms are accepted, and a note states how they were interpreted
/// (docs/logs.md): names in English or German, with a unit behind the name or in a row of units; columns with other
/// names, if exactly one has a unit of time, of length or of force; any unit of UDUNITS-2; times of day and dates;
/// semicolons, tabs or blanks as separators; decimal commas; thousands separators; quotes; comments and a preamble;
/// UTF-8, UTF-16 and Latin-1; LF, CRLF and CR; gzip. Columns that are not needed, rows that repeat the preceding row,
/// and rows without a number, if they are few, are omitted with a note. Times are rounded to nanoseconds.
/// Throws LogError with file, line and reason: if columns or decimal marks are ambiguous (the error names the option
/// that resolves this), a field is not a number, rows differ in length, the time does not increase, the file contains
/// several logs and the format selects none of them, or there are fewer than two rows.
Log readCsvLog(const std::string& path, const LogFormat& format = {});

/// Reads a log of the format that the content of the file shows: MATLAB, HDF5, RPC III or text. Level 4 of MATLAB is
/// recognised by the extension .mat instead. Throws LogError, also if several segments are requested.
Log readLog(const std::string& path, const LogFormat& format = {});

/// Reads the log of a file, or each of its segments if the format requests all segments. Throws LogError.
std::vector<Log> readLogs(const std::string& path, const LogFormat& format = {});

/// Checks a log from any source: displacement, force and temperature have a finite value for each stamp, the time
/// increases, and there are at least two samples. Throws LogError that names the log, the sample and the value.
void checkLog(const Log& log);

/// The parts of checkLog(): a check of the lengths, and a check of the samples [first, first + count).
void checkLengths(const Log& log);
void checkSamples(const Log& log, std::size_t first, std::size_t count);

/// Writes the columns `time_s,displacement_m` and, if requested, `force_N` row by row. Times are exact decimals. The
/// other numbers have 17 digits, so that reading returns the same bits. The file has a temporary name until close()
/// renames it. Without close(), the file is removed. All functions throw LogError.
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

/// Writes `time_s,displacement_m,force_N` as LogCsvWriter does, with the given forces. Throws LogError.
void writeForceCsv(const std::string& path, const Log& log, const std::vector<double>& force);

/// Writes `time_s,displacement_m` and any measured `force_N` as LogCsvWriter does. Throws LogError.
void writeLogCsv(const std::string& path, const Log& log);

}  // namespace rubber_suspension::log
