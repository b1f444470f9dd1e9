// Runs a command and reports its errors.
#include "command_line/command.h"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <new>
#include <streambuf>

#include "command_line/parse.h"
#include "element/largest_number.h"
#include "element/refuse.h"
#include "io/output_files.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::command_line {
namespace {

std::string accepted(const Quantity& quantity, const std::string& unit, double value = 0.0) {
  return quantity.accepted.empty() ? element::acceptedFor(value, quantity.range) + " " + unit : quantity.accepted;
}

// Returns the unit in which an error states the range. The range "greater than 0" is the same in the user's unit, which
// is preferred. Other ranges are stated in the unit of the quantity.
std::string unitForRange(const std::string& text, const Quantity& quantity) {
  const bool in_any_unit = quantity.range.lower == 0.0 && std::isinf(quantity.range.upper);
  const std::string written = log::unitOfQuantity(text);
  return in_any_unit && !written.empty() ? written : quantity.unit;
}

std::vector<std::string> pathsOf(const Option& option) {
  if (const auto* const* several = std::get_if<std::vector<std::string>*>(&option.target)) {
    return **several;
  }
  return {*std::get<std::string*>(option.target)};
}

bool writes(const Option& option) { return option.kind || option.files; }

bool isGiven(const io::OutputFile& output) { return !output.path.empty(); }

// Checks the files that the options name, before any file is read.
void checkFiles(const OptionTable& table, bool force) {
  Files all;
  std::vector<io::InputFile> logs;
  for (const Option& option : table.options()) {
    const Files more = option.files ? option.files() : Files();
    all.inputs.insert(all.inputs.end(), more.inputs.begin(), more.inputs.end());
    all.outputs.insert(all.outputs.end(), more.outputs.begin(), more.outputs.end());
    for (const std::string& path : option.is_input || option.kind ? pathsOf(option) : std::vector<std::string>()) {
      if (option.is_input) {
        all.inputs.push_back({option.name, path});
        if (option.is_each_once) {
          logs.push_back(all.inputs.back());
        }
      } else {
        all.outputs.push_back({option.name, path, *option.kind});
      }
    }
  }
  element::refuseIf<UsageError>(force && std::none_of(all.outputs.begin(), all.outputs.end(), isGiven),
                                "--force has no effect because no file is written; accepted: without --force");
  io::refuseEqualLogs(logs);
  io::checkOutputs(all.inputs, all.outputs, force);
}

int runAsked(int argc, char** argv, const Command& command, const OptionTable& own, const std::function<int()>& body) {
  bool force = false;
  OptionTable table = own;
  if (std::any_of(own.options().begin(), own.options().end(), writes)) {
    table = {own,
             Option("--force", force, "also replace an existing file of another kind than the command writes").rare()};
  }
  // The help is made first, because it shows the defaults, which parse() overwrites.
  const std::string help = helpText(command, table, HelpSize::screen);
  const std::string all = helpText(command, table, HelpSize::all);
  switch (parse(argc, argv, command, table)) {
    case Request::help:
      std::cout << help;
      return kSuccess;
    case Request::help_all:
      std::cout << all;
      return kSuccess;
    case Request::version:
      std::cout << command.name << " " << version() << '\n';
      return kSuccess;
    case Request::run:
      checkFiles(table, force);
      return body();
  }
  return kFailed;
}

// Writes text to standard output line by line, without the control characters that names of files may contain.
class SafeOutput : std::streambuf {
 public:
  SafeOutput() : terminal_(std::cout.rdbuf(this)) {}
  SafeOutput(const SafeOutput&) = delete;
  SafeOutput& operator=(const SafeOutput&) = delete;
  ~SafeOutput() override {
    SafeOutput::sync();
    std::cout.rdbuf(terminal_);
  }

 private:
  int_type overflow(int_type c) override {
    if (c == '\n') {
      return write('\n') ? c : traits_type::eof();
    }
    line_ += traits_type::to_char_type(c);
    return c;
  }

  int sync() override { return (line_.empty() || write('\0')) && terminal_->pubsync() == 0 ? 0 : -1; }

  // `end` is '\n', or '\0' if no line end is to be written.
  bool write(char end) {
    std::string safe = log::oneLine(line_);
    line_.clear();
    safe += end == '\0' ? "" : "\n";
    const auto size = static_cast<std::streamsize>(safe.size());
    return terminal_->sputn(safe.data(), size) == size;
  }

  std::streambuf* terminal_;
  std::string line_;
};

// Configures malloc. It reserves 64 MiB of addresses for each thread, so all threads share one arena if addresses are
// limited. Otherwise freed memory is kept, because clearing new pages takes a quarter of the time of a fit.
void setUpMemory() {
  constexpr int kLargestKept = 32 << 20;  // bytes; the largest value that malloc accepts
  constexpr int kKept = 256 << 20;
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    mallopt(M_ARENA_MAX, 1);
    return;
  }
  mallopt(M_MMAP_THRESHOLD, kLargestKept);
  mallopt(M_TRIM_THRESHOLD, kKept);
}

}  // namespace

std::string version() { return RUBBER_SUSPENSION_VERSION; }

void printError(const std::string& command, const std::string& message) {
  std::cerr << command << ": " << log::oneLine(message) << '\n';
}

void printNote(const std::string& command, const std::string& note) { printError(command, "note: " + note); }

void printNotes(const std::string& command, const std::vector<std::string>& notes) {
  std::for_each(notes.begin(), notes.end(), [&](const std::string& note) { printNote(command, note); });
}

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
                                 accepted(quantity, unitForRange(text, quantity), value)));
  }
  return value;
}

int runCommand(int argc, char** argv, const Command& command, const OptionTable& table,
               const std::function<int()>& body) {
  setUpMemory();
  const SafeOutput output;
  try {
    const int status = runAsked(argc, argv, command, table, body);
    element::refuseIf<std::runtime_error>(!std::cout.flush(), "standard output cannot be written");
    return status;
  } catch (const UsageError& error) {
    printError(command.name, error.what());
    return kWrongUsage;
  } catch (const io::OutputRefused& error) {
    printError(command.name, error.what());
    return kWrongUsage;
  } catch (const std::bad_alloc&) {
    printError(command.name, "out of memory; accepted: shorter logs, fewer --threads or a larger limit (ulimit -v)");
    return kFailed;
  } catch (const std::exception& error) {
    printError(command.name, error.what());
    return kFailed;
  }
}

}  // namespace rubber_suspension::command_line
