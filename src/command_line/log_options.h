// The options that say how to read a log, the same for every command that reads one.
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
  /// --columns, --unit, --sampling-rate, --decimal, --segment, --bridge, --sentinel and --clock.
  OptionTable table();

  /// --accept-units, of the commands that hold logs against a component.
  Option acceptUnits();
  bool acceptsUnits() const { return accept_units_; }

  /// The names of those of table(), for rules.
  static const std::vector<std::string>& names();

  /// Refuses those options that act on text where all logs are bags. Throws UsageError.
  void requireUse(const std::vector<std::string>& paths) const;

  /// Read a log of any kind; of a bag, that of the component. Its notes go to stderr. Throws UsageError and LogError.
  log::Log read(const std::string& command, const std::string& path, const std::string& component) const;

  /// Reads the log of a component of six directions; rotations of a bag come in this measure.
  log::PoseLog readPoses(const std::string& command, const std::string& path, const std::string& component,
                         component::RotationMeasure measure) const;

  /// The logs of a file without their notes (several threads may read at once), more than one where --segment asks for
  /// all of them.
  std::vector<log::Log> readAll(const std::string& path, const std::string& component) const;

  /// Opens the logs to be read block by block; several threads may do so at once. Throws UsageError and LogError.
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
