// The options that say how to read a log, the same for every command that reads one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "command_line/option_table.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::command_line {

class LogOptions {
 public:
  /// --columns, --unit and --sampling-rate.
  OptionTable table();

  /// The names of these, for rules.
  static const std::vector<std::string>& names();

  /// Refuses the options where all logs are bags, which tell columns, units and time themselves. Throws UsageError.
  void requireUse(const std::vector<std::string>& paths) const;

  /// Read a log of any kind; of a bag, that of the component. Its notes go to stderr. Throws UsageError and LogError.
  log::Log read(const std::string& command, const std::string& path, const std::string& component) const;

  /// The same without its notes; several threads may read at once.
  log::Log readSilently(const std::string& path, const std::string& component) const;

  /// A log that is read block by block; several threads may open at once. Throws UsageError and LogError.
  std::shared_ptr<const log::LogSource> open(const std::string& path, const std::string& component) const;

  static void printNotes(const std::string& command, const std::string& path, const std::vector<std::string>& notes);

 private:
  log::LogFormat format() const;

  std::vector<std::string> columns_;
  std::string unit_;
  double sampling_rate_ = 0.0;  // [Hz]; 0: not given
};

}  // namespace rubber_suspension::command_line
