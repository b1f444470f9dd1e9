// A recorded log: displacement and force over time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rubber_suspension::log {

/// A log in SI units; all vectors that are not empty have the same length.
struct Log {
  std::string name;                  ///< file name without folder and extension
  std::vector<std::int64_t> stamp;   ///< [ns]
  std::vector<double> displacement;  ///< [m]
  std::vector<double> force;         ///< measured [N]; empty if the log has none
  std::vector<double> temperature;   ///< [degC]; empty if the log has none
  std::vector<std::string> notes;    ///< what was ignored and why

  std::size_t size() const { return stamp.size(); }
  double time(std::size_t i) const { return static_cast<double>(stamp[i]) * 1e-9; }  ///< [s]
};

/// A log that was refused. what() is one line: file:line and reason.
class LogError : public std::runtime_error {
 public:
  explicit LogError(const std::string& message);
};

/// How to find time, displacement and force in a file whose columns do not follow the rule of names.
struct LogFormat {
  std::string time_column;          ///< empty: time_s
  std::string displacement_column;  ///< empty: displacement_<unit>
  std::string force_column;         ///< empty: force_<unit>
  std::string temperature_column;   ///< empty: temperature_degC
  std::string displacement_unit;    ///< of that column, or one named `displacement`; empty: by its name, else m
  std::string force_unit;           ///< likewise; empty: N
  std::string time_unit;            ///< of a time column of another name; empty: by its name, else s
  std::optional<double> rate;       ///< sampling rate [Hz] of a log without time column; the first sample is at 0 s
};

/// The format that options of a command describe: `--columns displacement=D force=F`, `--unit mm,kN,ms`, `--rate 1000`
/// (rate 0: not given). Throws std::invalid_argument that names option, value and what is accepted.
LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate);

/// Bounds on a CSV log; a file beyond them is refused.
constexpr std::size_t kMaximumLogRows = 20000000;   // 5.5 hours at 1 kHz
constexpr std::size_t kMaximumLogLine = 64 * 1024;  // bytes

/// Read a CSV log: a header with columns time_s, displacement_<m|mm|um>, force_<N|kN|MN> (optional), temperature_degC
/// (optional); then one row per sample. Separator is the comma; line ends LF or CRLF, UTF-8 with or without byte order
/// mark. Any further column is ignored with a note. Refused, with file, line and reason: a field that is no finite
/// number, a row of another length, a blank line between rows, time that does not increase from row to row, less than
/// two rows. Time becomes the nearest integer nanosecond. Throws LogError.
Log readCsvLog(const std::string& path, const LogFormat& format = {});

/// Read a MATLAB file (level 4 to 7.3). Its columns are real vectors of numbers: variables, named as NAME, and fields
/// of structs, named as STRUCT.NAME; where the file holds one struct and nothing else, its name may be left out. Which
/// columns are read follows the rules of readCsvLog. Throws LogError.
Log readMatLog(const std::string& path, const LogFormat& format = {});

/// Read a log by its extension: .mat a MATLAB file, otherwise CSV. Throws LogError.
Log readLog(const std::string& path, const LogFormat& format = {});

/// Check a log from any source: lengths agree, time increases, all is finite, at least two samples.
/// Throws LogError that names log, sample and value.
void checkLog(const Log& log);

/// checkLog() in pieces, for who goes through a log anyhow: first its lengths, then its samples from `first` on.
void checkLengths(const Log& log);
void checkSamples(const Log& log, std::size_t first, std::size_t count);

/// Writes `time_s,displacement_m` and, if wanted, `force_N`, piece by piece; time as exact decimal, the others with 17
/// digits: all reads back bit by bit. All calls throw LogError.
class LogCsvWriter {
 public:
  LogCsvWriter(const std::string& path, bool with_force);

  void append(std::int64_t stamp, double displacement, double force = 0.0);
  void close();

 private:
  void fail() const;

  std::string path_;
  bool with_force_;
  std::ofstream file_;
};

/// Write `time_s,displacement_m,force_N`; time as exact decimal, the others with 17 digits: all reads back bit by bit.
/// Throws LogError.
void writeForceCsv(const std::string& path, const Log& log, const std::vector<double>& force);

/// Write `time_s,displacement_m` and, if the log has a measured force, `force_N`, as exactly. Throws LogError.
void writeLogCsv(const std::string& path, const Log& log);

}  // namespace rubber_suspension::log
