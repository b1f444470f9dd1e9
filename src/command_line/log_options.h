// The options that specify how to read a log, the same for every command that reads one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "command_line/option_table.h"
#include "rubber_suspension/component/rotation_measure.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::command_line {

class LogOptions {
 public:
  /// Returns --columns, --unit, --sampling-rate, --decimal, --segment, --bridge, --sentinel, --clock and --large.
  OptionTable table();

  /// Returns --accept-units, for commands that compare logs with a component.
  Option acceptUnits();
  bool acceptsUnits() const { return accept_units_; }

  /// Returns the names of the options of table(), for rules.
  static const std::vector<std::string>& names();

  /// Throws UsageError for options that have no effect on a bag if all logs are bags, and for --clock if none is.
  void requireUse(const std::vector<std::string>& paths) const;

  /// Reads a log of any kind, from a bag that of the component. Prints its notes. Throws UsageError and LogError.
  log::Log read(const std::string& command, const std::string& path, const std::string& component) const;

  /// Reads the log of a component of six directions; rotations of a bag are converted to this measure.
  log::PoseLog readPoses(const std::string& command, const std::string& path, const std::string& component,
                         component::RotationMeasure measure) const;

  /// Reads the logs of a file, several if --segment selects all, without printing their notes. Several threads may call
  /// it at once.
  std::vector<log::Log> readAll(const std::string& path, const std::string& component) const;

  /// Opens the logs for reading in blocks; several threads may call it at once. Throws UsageError and LogError.
  log::LogSources openAll(const std::string& path, const std::string& component) const;

  static void printNotes(const std::string& command, const std::string& path, const std::vector<std::string>& notes);

 private:
  log::LogFormat format() const;

  std::vector<std::string> columns_;
  std::vector<std::string> unit_;
  double sampling_rate_ = 0.0;  // [Hz]; 0: not given
  std::string decimal_;
  std::string segment_;
  double bridge_ = -1.0;  // [s]; less than 0: not given
  std::string sentinel_;
  std::string clock_;
  bool accept_units_ = false;
  bool large_ = false;
};

}  // namespace rubber_suspension::command_line
