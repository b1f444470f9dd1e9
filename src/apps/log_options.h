// The options that say how to read a log, the same for every command that reads one.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "bag/bag_log.h"

namespace rubber_suspension::apps {

class LogOptions {
 public:
  /// Adds --columns, --unit and --sampling-rate; the object has to live as long as the parser.
  void addTo(CLI::App& app) {
    app.add_option(
           "--columns", columns_,
           "columns that the log's header does not tell: time=NAME displacement=NAME force=NAME "
           "temperature=NAME, where NAME may be a number from 1; or the words alone, in the order of the columns")
        ->type_name("QUANTITY=NAME");
    app.add_option("--unit", unit_, "units of columns, such as force=kN displacement=mm")->type_name("QUANTITY=UNIT");
    app.add_option("--decimal", decimal_, "decimal mark of a text, , or .")->type_name("MARK");
    app.add_option("--segment", segment_, "which of several logs in one file, from 1, or all")->type_name("NUMBER");
    app.add_option("--bridge", bridge_, "longest time without a number that is passed over")->type_name("SECONDS");
    app.add_option("--sampling-rate", sampling_rate_, "sampling rate of a log without a time column")->type_name("HZ");
  }

  /// Refuses the options where all logs are bags, which tell columns, units and time themselves. Throws UsageError.
  void requireUse(const std::vector<std::string>& paths) const {
    const bool given = !columns_.empty() || !unit_.empty() || sampling_rate_ > 0.0;
    if (given && std::all_of(paths.begin(), paths.end(), bag::isBagPath)) {
      throw UsageError("--columns, --unit and --sampling-rate have no effect on a bag; accepted: without them");
    }
  }

  /// Read a log of any kind; of a bag, that of the component. Its notes go to stderr. Throws UsageError and LogError.
  log::Log read(const std::string& command, const std::string& path, const std::string& component) const {
    log::Log log = readSilently(path, component);
    printNotes(command, path, log.notes);
    return log;
  }

  /// The same without its notes; several threads may read at once.
  log::Log readSilently(const std::string& path, const std::string& component) const {
    return bag::readAnyLog(path, component, format());
  }

  /// A log that is read block by block; several threads may open at once. Throws UsageError and LogError.
  std::shared_ptr<const log::LogSource> open(const std::string& path, const std::string& component) const {
    return bag::openAnyLog(path, component, format());
  }

  static void printNotes(const std::string& command, const std::string& path, const std::vector<std::string>& notes) {
    for (const std::string& note : notes) {
      printNote(command, path + ": " + note);
    }
  }

 private:
  log::LogFormat format() const {
    try {
      return log::makeLogFormat(columns_, fmt::format("{}", fmt::join(unit_, " ")), sampling_rate_, decimal_, segment_,
                                bridge_);
    } catch (const std::invalid_argument& error) {
      throw UsageError(error.what());
    }
  }

  std::vector<std::string> columns_;
  std::vector<std::string> unit_;
  std::string decimal_;
  std::string segment_;
  double bridge_ = -1.0;
  double sampling_rate_ = 0.0;
};

}  // namespace rubber_suspension::apps
