// The frame of every command.
#include "command_line/command.h"

#include <fmt/format.h>

#include <cmath>

#include "command_line/parse.h"
#include "io/output_files.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::command_line {
namespace {

std::string accepted(const Quantity& quantity, const std::string& unit) {
  return quantity.accepted.empty() ? element::describe(quantity.range) + " " + unit : quantity.accepted;
}

// A bound of 0 is the same in the unit that the user wrote.
std::string unitForRange(const std::string& text, const Quantity& quantity) {
  const bool in_any_unit = quantity.range.lower == 0.0 && std::isinf(quantity.range.upper);
  const std::string written = log::unitOfQuantity(text);
  return in_any_unit && !written.empty() ? written : quantity.unit;
}

int runAsked(int argc, char** argv, const Command& command, const OptionTable& table,
             const std::function<int()>& body) {
  const std::string help = helpText(command, table);  // before the defaults are overwritten
  switch (parse(argc, argv, command, table)) {
    case Request::help:
      std::cout << help;
      return kSuccess;
    case Request::version:
      std::cout << command.name << " " << version() << '\n';
      return kSuccess;
    case Request::run:
      return body();
  }
  return kFailed;
}

}  // namespace

std::string version() { return RUBBER_SUSPENSION_VERSION; }

void printError(const std::string& command, const std::string& message) {
  std::cerr << command << ": " << log::oneLine(message) << '\n';
}

void printNote(const std::string& command, const std::string& note) { printError(command, "note: " + note); }

void printWarning(const std::string& command, const std::string& warning) {
  printError(command, "warning: " + warning);
}

double quantityOf(const std::string& option, const std::string& text, const Quantity& quantity) {
  double value = 0.0;
  try {
    value = log::parseQuantity(text, quantity.unit);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("{}: {}: {}; accepted: {}", option, log::quoted(text), error.what(),
                                 accepted(quantity, quantity.unit)));
  }
  if (!quantity.range.contains(value)) {
    throw UsageError(fmt::format("{}: {} is out of range; accepted: {}", option, log::quoted(text),
                                 accepted(quantity, unitForRange(text, quantity))));
  }
  return value;
}

int runCommand(int argc, char** argv, const Command& command, const OptionTable& table,
               const std::function<int()>& body) {
  try {
    const int status = runAsked(argc, argv, command, table, body);
    if (!std::cout.flush()) {
      throw std::runtime_error("standard output cannot be written");
    }
    return status;
  } catch (const UsageError& error) {
    printError(command.name, error.what());
    return kWrongUsage;
  } catch (const io::OutputRefused& error) {
    printError(command.name, error.what());
    return kWrongUsage;
  } catch (const std::exception& error) {
    printError(command.name, error.what());
    return kFailed;
  }
}

}  // namespace rubber_suspension::command_line
