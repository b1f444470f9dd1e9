// A recorded log: displacement and force over time.
#pragma once

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

/// How to find time, displacement and force in a file whose columns do not tell it themselves. A column goes by its
/// name in the file, with its unit or without, or by its number from 1.
struct LogFormat {
  std::string time_column;          ///< empty: by name or unit
  std::string displacement_column;  ///< likewise
  std::string force_column;         ///< likewise
  std::string temperature_column;   ///< likewise
  std::string displacement_unit;    ///< of a column whose unit the file does not tell, or that is given above
  std::string force_unit;           ///< likewise
  std::string time_unit;            ///< likewise
  std::optional<double> rate;       ///< sampling rate [Hz] of a log without time column; the first sample is at 0 s
};

/// The format that options of a command describe: `--columns displacement=D force=F`, or the quantities in the order of
/// the columns, `--columns time displacement force`; `--unit mm,kN,ms`; `--sampling-rate 1000` (rate 0: not given).
/// Throws std::invalid_argument that names option, value and what is accepted.
LogFormat makeLogFormat(const std::vector<std::string>& columns, const std::string& units, double rate);

/// Bounds on a CSV log; a file beyond them is refused.
constexpr std::size_t kMaximumLogRows = 20000000;   // 5.5 hours at 1 kHz
constexpr std::size_t kMaximumLogLine = 64 * 1024;  // bytes

/// Read a log from text. Canonical, and read fastest, is what this package writes: a header with columns time_s,
/// displacement_<m|mm|um>, force_<N|kN|MN> (optional), temperature_degC (optional), then one row per sample, separated
/// by commas. Read as well, with a note of what was taken for what: the plain names in English and German (time, Zeit;
/// displacement, deflection, Weg, Federweg, Auslenkung, Verschiebung, Einfederung; force, Kraft; temperature,
/// Temperatur) with a unit behind them or in a row of units; columns of other names where exactly one has a unit of
/// length, of force, of time; any unit of UDUNITS-2; separators semicolon, tab, blanks; decimal commas where the comma
/// separates nothing; quotes; comments and a preamble before the header, comments among the rows (with a note); UTF-8,
/// UTF-16, Latin-1, byte order marks; LF, CRLF, CR; gzip. Further columns are ignored with a note. Refused, with file,
/// line and reason: columns that are ambiguous, with the option that settles it; a field that is no finite number, a
/// row of another length, a blank line between rows, time that does not increase from row to row, less than two rows.
/// Time becomes the nearest integer nanosecond. Throws LogError.
Log readCsvLog(const std::string& path, const LogFormat& format = {});

/// Read a MATLAB file (level 4 to 7.3). Its columns are real vectors of numbers: variables, named as NAME, and fields
/// of structs, named as STRUCT.NAME; where the file holds one struct and nothing else, its name may be left out. A
/// matrix has a column for each of its columns (rows where it is wider than long), named NAME(:,1), or 1 where the file
/// holds nothing else. Which columns are read follows the rules of readCsvLog. Throws LogError.
Log readMatLog(const std::string& path, const LogFormat& format = {});

/// Read an HDF5 file. Its columns are one-dimensional datasets of numbers, named by their path without the first slash,
/// or by their own name where all lie in one group; those of a matrix are named NAME[:,1] and so on. An attribute
/// `unit`, `units`, `Unit` or `Units` tells the unit. Which columns are read follows the rules of readCsvLog. Throws
/// LogError.
Log readHdf5Log(const std::string& path, const LogFormat& format = {});

/// Read a log by its content: MATLAB (level 4 by the extension .mat), HDF5, otherwise text. Throws LogError.
Log readLog(const std::string& path, const LogFormat& format = {});

/// Check a log from any source: lengths agree, time increases, all is finite, at least two samples.
/// Throws LogError that names log, sample and value.
void checkLog(const Log& log);

/// checkLog() in pieces, for who goes through a log anyhow: first its lengths, then its samples from `first` on.
void checkLengths(const Log& log);
void checkSamples(const Log& log, std::size_t first, std::size_t count);

/// Writes `time_s,displacement_m` and, if wanted, `force_N`, piece by piece; time as exact decimal, the others with 17
/// digits: all reads back bit by bit. The file is written beside and takes its name in close(), complete; without that
/// call nothing is left. All calls throw LogError.
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

/// Write `time_s,displacement_m,force_N`; time as exact decimal, the others with 17 digits: all reads back bit by bit.
/// Throws LogError.
void writeForceCsv(const std::string& path, const Log& log, const std::vector<double>& force);

/// Write `time_s,displacement_m` and, if the log has a measured force, `force_N`, as exactly. Throws LogError.
void writeLogCsv(const std::string& path, const Log& log);

}  // namespace rubber_suspension::log
