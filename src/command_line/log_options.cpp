// The options that say how to read a log.
#include "command_line/log_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "bag/bag_log.h"
#include "command_line/command.h"

namespace rubber_suspension::command_line {

OptionTable LogOptions::table() {
  return {
      Option("--columns", columns_, "QUANTITY=NAME",
             "columns that the log's header does not tell: time=NAME displacement=NAME force=NAME "
             "temperature=NAME, where NAME may be a number from 1; or the words alone, in the order of the columns"),
      Option("--unit", unit_, "LENGTH,FORCE,TIME",
             "units of columns that do not tell theirs, such as mm,kN or mm,kN,ms"),
      Option("--sampling-rate", Quantity{&sampling_rate_, "Hz"}, "HZ", "sampling rate of a log without a time column")};
}

const std::vector<std::string>& LogOptions::names() {
  static const std::vector<std::string> all = {"--columns", "--unit", "--sampling-rate"};
  return all;
}

void LogOptions::requireUse(const std::vector<std::string>& paths) const {
  const bool given = !columns_.empty() || !unit_.empty() || sampling_rate_ > 0.0;
  if (given && std::all_of(paths.begin(), paths.end(), bag::isBagPath)) {
    throw UsageError("--columns, --unit and --sampling-rate have no effect on a bag; accepted: without them");
  }
}

log::Log LogOptions::read(const std::string& command, const std::string& path, const std::string& component) const {
  log::Log log = readSilently(path, component);
  printNotes(command, path, log.notes);
  return log;
}

log::Log LogOptions::readSilently(const std::string& path, const std::string& component) const {
  return bag::readAnyLog(path, component, format());
}

std::shared_ptr<const log::LogSource> LogOptions::open(const std::string& path, const std::string& component) const {
  return bag::openAnyLog(path, component, format());
}

void LogOptions::printNotes(const std::string& command, const std::string& path,
                            const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    printNote(command, path + ": " + note);
  }
}

log::LogFormat LogOptions::format() const {
  try {
    return log::makeLogFormat(columns_, unit_, sampling_rate_);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace rubber_suspension::command_line
