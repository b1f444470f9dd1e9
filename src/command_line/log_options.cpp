// The options that specify how to read a log.
#include "command_line/log_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "bag/bag_log.h"
#include "command_line/command.h"
#include "element/refuse.h"

namespace rubber_suspension::command_line {

OptionTable LogOptions::table() {
  return {Option("--columns", columns_, "QUANTITY=NAME",
                 "columns of the log: time=NAME displacement=NAME force=NAME temperature=NAME, where NAME is a name or "
                 "a number from 1, optionally with a factor (force=-NAME, force=0.001*NAME); or the names of the "
                 "quantities alone, in the order of the columns; for a bag with other topics, NAME is a field, as in "
                 "force=/ft/wrench.force.z")
              .rare(),
          Option("--unit", unit_, "QUANTITY=UNIT", "units of columns, such as displacement=mm force=kN time=ms").rare(),
          Option("--sampling-rate", Quantity{&sampling_rate_, "Hz"}, "HZ",
                 "sampling rate of a log without a time column, or with stamps that are equal, swapped or rounded")
              .rare(),
          Option("--decimal", decimal_, "MARK",
                 "decimal mark of a text log: . or , (point or comma); force=, sets the mark of a single column")
              .rare(),
          Option("--segment", segment_, "NUMBER",
                 "number of the log to read from a file with several logs, from 1; all: every log")
              .rare(),
          Option("--bridge", Quantity{&bridge_, "s", element::Range::closed(0.0, 3600.0)}, "SECONDS",
                 "longest time without numbers that is interpolated (default: 0.5 if 99 % of the rows have numbers)")
              .rare(),
          Option("--sentinel", sentinel_, "NUMBER",
                 "number that marks missing values, or none (default: a number that recurs far outside all others)")
              .rare(),
          Option("--clock", clock_, "CLOCK",
                 "times of the messages in a bag: header (their stamps) or receipt (times of recording, for messages "
                 "without stamps)")
              .rare(),
          Option("--large", large_, "also read a compressed file that expands more than a hundred times").rare()};
}

Option LogOptions::acceptUnits() {
  return Option(
             "--accept-units", accept_units_,
             "take the units and the component as correct: accept any factor between measured and configured stiffness")
      .rare();
}

const std::vector<std::string>& LogOptions::names() {
  static const std::vector<std::string> all = {"--columns", "--unit",     "--sampling-rate", "--decimal", "--segment",
                                               "--bridge",  "--sentinel", "--clock",         "--large"};
  return all;
}

void LogOptions::requireUse(const std::vector<std::string>& paths) const {
  const bool of_text = !decimal_.empty() || !segment_.empty() || bridge_ >= 0.0;
  element::refuseIf<UsageError>(of_text && std::all_of(paths.begin(), paths.end(), bag::isBagPath),
                                "--decimal, --segment and --bridge have no effect on a bag; accepted: without them");
  element::refuseIf<UsageError>(!clock_.empty() && std::none_of(paths.begin(), paths.end(), bag::isBagPath),
                                "--clock has an effect on bags only; accepted: without --clock");
}

log::Log LogOptions::read(const std::string& command, const std::string& path, const std::string& component) const {
  log::Log log = during("reading " + path, [&] { return bag::readAnyLog(path, component, format()); });
  printNotes(command, path, log.notes);
  return log;
}

log::PoseLog LogOptions::readPoses(const std::string& command, const std::string& path, const std::string& component,
                                   component::RotationMeasure measure) const {
  const bool is_bag = bag::isBagPath(path);
  element::refuseIf<UsageError>(
      is_bag && !(columns_.empty() && unit_.empty() && clock_.empty() && sampling_rate_ == 0.0),
      "--columns, --unit, --clock and --sampling-rate have no effect on a bag of poses; accepted: without them");
  log::PoseLog log = during("reading " + path, [&] {
    return is_bag ? bag::readBagPoses(path, component, measure) : log::readPoseLog(path, format());
  });
  log.units = accept_units_ ? log::UnitsAre::accepted : log.units;
  printNotes(command, path, log.notes);
  return log;
}

std::vector<log::Log> LogOptions::readAll(const std::string& path, const std::string& component) const {
  return bag::readAnyLogs(path, component, format());
}

log::LogSources LogOptions::openAll(const std::string& path, const std::string& component) const {
  return bag::openAnyLogs(path, component, format());
}

void LogOptions::printNotes(const std::string& command, const std::string& path,
                            const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    printNote(command, path + ": " + note);
  }
}

log::LogFormat LogOptions::format() const {
  log::LogFormat format = asUsage("", [&] {
    return log::makeLogFormat(columns_, fmt::format("{}", fmt::join(unit_, " ")), sampling_rate_, decimal_, segment_,
                              bridge_, sentinel_, clock_);
  });
  format.accept_units = accept_units_;
  format.large = large_;
  return format;
}

}  // namespace rubber_suspension::command_line
