// A recorded log: displacement and force over time.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace rubber_suspension {

/// A log in SI units; all vectors that are not empty have the same length.
struct Log {
  std::string name;                   ///< file name without folder and extension
  std::vector<std::int64_t> stamp;    ///< [ns]
  std::vector<double> displacement;   ///< [m]
  std::vector<double> force;          ///< measured [N]; empty if the log has none
  std::vector<double> temperature;    ///< [degC]; empty if the log has none
  std::vector<std::string> notes;     ///< what was ignored and why

  std::size_t size() const { return stamp.size(); }
  double time(std::size_t i) const { return static_cast<double>(stamp[i]) * 1e-9; }  ///< [s]
};

/// A log that was refused. what() is one line: file:line and reason.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Read a CSV log (columns time_s, displacement_<unit>, force_<unit>, temperature_degC). Throws LogError.
/// Time has to increase from row to row; every number has to be finite.
Log readCsvLog(const std::string& path);

/// Write `time_s,displacement_m,force_N`, 17 digits, so that it reads back bit by bit. Throws LogError.
void writeForceCsv(const std::string& path, const Log& log, const std::vector<double>& force);

}  // namespace rubber_suspension
