// The frame of every command: options, --version, exit status, errors in one line.
#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/help_format.h"
#include "element/suggestion.h"
#include "io/output_files.h"
#include "log/text.h"

namespace rubber_suspension::apps {

/// Options that are each right, but not together: exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum ExitStatus : int { kSuccess = 0, kFailed = 1, kWrongUsage = 2 };

struct VersionRequest {};

/// What a command does once its options are read; returns the exit status.
using CommandBody = std::function<int()>;

/// One line on stderr, in which nothing of a file's content can steer the terminal.
inline void printError(const std::string& command, const std::string& message) {
  std::cerr << command << ": " << log::oneLine(message) << '\n';
}

inline void printNote(const std::string& command, const std::string& note) {
  std::cerr << command << ": note: " << log::oneLine(note) << '\n';
}

/// No option is without effect: throws UsageError where one of these is given; `reason` says what they do not go with.
inline void refuseUnused(const CLI::App& app, const std::vector<std::string>& options, const std::string& reason) {
  for (const std::string& option : options) {
    if (app.count(option) > 0) {
      throw UsageError(option + " has no effect " + reason);
    }
  }
}

/// What is wrong with the first option that the command does not have, with the one that was probably meant; empty
/// where it has all.
inline std::string unknownOption(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back(name);
    }
  }
  for (const std::string& word : app.remaining()) {
    const std::string given = word.substr(0, word.find('='));
    if (given.rfind("--", 0) == 0) {
      const auto meant = element::nearestWord(given.substr(2), names);
      return "no option " + given + (meant ? " (did you mean --" + *meant + "?)" : "") + "; accepted: those of --help";
    }
  }
  return "";
}

/// Run a command. `define` adds the options to the parser and returns the body; the variables that the options fill
/// have to live as long as the body, so let it own them (a shared_ptr). An exception of the body is printed as one line
/// on stderr and ends in exit status 1, wrong options in 2.
inline int runCommand(int argc, char** argv, const std::string& name, const std::string& description,
                      const std::function<CommandBody(CLI::App&)>& define) {
  try {
    CLI::App app(description, name);
    app.formatter(std::make_shared<HelpFormat>());
    app.add_flag_callback(
        "--version", [] { throw VersionRequest(); }, "Print the version and exit");
    const CommandBody body = define(app);
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& request) {  // --help
      return app.exit(request);
    } catch (const VersionRequest&) {
      std::cout << name << " " << RUBBER_SUSPENSION_VERSION << '\n';
      return kSuccess;
    } catch (const CLI::ParseError& error) {
      // A misspelt option is said first: that another is missing may follow from it.
      const std::string unknown = unknownOption(app);
      throw UsageError(unknown.empty() ? std::string(error.what()) + " (see --help)" : unknown);
    }
    const int status = body();
    if (!std::cout.flush()) {
      throw std::runtime_error("standard output cannot be written");
    }
    return status;
  } catch (const UsageError& error) {
    printError(name, error.what());
    return kWrongUsage;
  } catch (const io::OutputRefused& error) {
    printError(name, error.what());
    return kWrongUsage;
  } catch (const std::exception& error) {
    printError(name, error.what());
    return kFailed;
  }
}

}  // namespace rubber_suspension::apps
