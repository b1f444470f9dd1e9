// The options that specify how to read a log, which are the same for all commands.
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
  OptionTable table();

  /// Returns --accept-units, for commands that compare logs with a component.
  Option acceptUnits();
  bool acceptsUnits() const { return accept_units_; }

  /// Returns the names of the options of table(), for rules about them.
  static const std::vector<std::string>& names();

  /// Throws UsageError for --decimal, --segment or --bridge if all logs are bags, and for --clock if none is a bag.
  void requireUse(const std::vector<std::string>& paths) const;

  /// Reads a log of any kind and prints its notes. `component` selects topics of a bag. Throws UsageError and LogError.
  log::Log read(const std::string& command, const std::string& path, const std::string& component) const;

  /// Reads the log of a component of six directions. Rotations in a bag are converted to `measure`.
  log::PoseLog readPoses(const std::string& command, const std::string& path, const std::string& component,
                         component::RotationMeasure measure) const;

  /// Reads the log of a file, or all logs if --segment requests them, and prints no notes. The function is thread-safe.
  std::vector<log::Log> readAll(const std::string& path, const std::string& component) const;

  /// Opens logs for reading in blocks. The function is thread-safe. Throws UsageError and LogError.
  log::LogSources openAll(const std::string& path, const std::string& component) const;

  static void printNotes(const std::string& command, const std::string& path, const std::vector<std::string>& notes);

 private:
  log::LogFormat format() const;

  std::vector<std::string> columns_;
  std::vector<std::string> unit_;
  double sampling_rate_ = 0.0;  // [Hz]; 0 if not given
  std::string decimal_;
  std::string segment_;
  double bridge_ = -1.0;  // [s]; negative if not given
  std::string sentinel_;
  std::string clock_;
  bool accept_units_ = false;
  bool large_ = false;
};

}  // namespace rubber_suspension::command_line
