// Formats the help of a command.
#include "command_line/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <sstream>
#include <type_traits>

namespace rubber_suspension::command_line {
namespace {

constexpr std::size_t kWidth = 100;
constexpr std::size_t kIndent = 28;

// Wraps a line. The text of a line "  name  text" is indented so that it continues beneath its own beginning.
std::string wrappedLine(const std::string& line, std::size_t indent) {
  const std::size_t gap = line.compare(0, 2, "  ") == 0 ? line.find("  ", 2) : std::string::npos;
  const std::size_t column = gap == std::string::npos ? 0 : line.find_first_not_of(' ', gap);
  std::string result = line.substr(0, column);
  std::size_t used = indent + column;
  std::istringstream words(line.substr(column));
  std::string separator;
  for (std::string word; words >> word; separator = " ") {
    if (used + separator.size() + word.size() > kWidth && !separator.empty()) {
      result += "\n" + std::string(indent + column, ' ');
      used = indent + column;
      separator.clear();
    }
    result += separator + word;
    used += separator.size() + word.size();
  }
  return result;
}

std::string wrapped(const std::string& text, std::size_t indent) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    result += (result.empty() ? "" : "\n" + std::string(indent, ' ')) + wrappedLine(line, indent);
  }
  return result;
}

// Returns the default of an option. A number outside its bounds and an empty text mean that the option is not given.
std::string defaultOf(const Option& option) {
  return std::visit(
      [&](const auto& target) -> std::string {
        using T = std::decay_t<decltype(target)>;
        if constexpr (std::is_same_v<T, std::string*>) {
          return *target;
        } else if constexpr (std::is_same_v<T, std::vector<int>*>) {
          return fmt::format("[{}]", fmt::join(*target, ","));
        } else if constexpr (std::is_same_v<T, double*> || std::is_same_v<T, int*> ||
                             std::is_same_v<T, std::uint64_t*>) {
          const auto value = static_cast<double>(*target);
          const bool shown =
              option.bounds ? value >= option.bounds->first && value <= option.bounds->second : value != 0.0;
          return shown ? numberText(value) : "";
        } else {
          return option.default_text;
        }
      },
      option.target);
}

// Returns for example " (1 to 64; default 2)".
std::string limitsOf(const Option& option) {
  std::vector<std::string> limits;
  if (option.is_required) {
    limits.emplace_back("required");
  }
  if (option.bounds) {
    limits.push_back(numberText(option.bounds->first) + " to " + numberText(option.bounds->second));
  }
  if (!option.words.empty()) {
    limits.push_back(fmt::format("{}", fmt::join(option.words, ", ")));
  }
  const std::string text = option.is_required ? "" : defaultOf(option);
  if (!text.empty()) {
    limits.push_back("default " + text);
  }
  return limits.empty() ? "" : fmt::format(" ({})", fmt::join(limits, "; "));
}

std::string placeholderOf(const Option& option) {
  if (option.isFlag() || option.isArgument()) {
    return "";
  }
  std::string word = " " + option.placeholder;
  if (option.most_values == 1) {
    return word;
  }
  return word + (option.least_values == option.most_values ? word : " ...");
}

std::string row(const std::string& name, const std::string& text) {
  std::string line = "  " + name;
  line += line.size() + 2 > kIndent ? "\n" + std::string(kIndent, ' ') : std::string(kIndent - line.size(), ' ');
  return line + wrapped(text, kIndent) + "\n";
}

std::string rows(const OptionTable& table, bool arguments, HelpSize size) {
  std::string text;
  for (const Option& option : table.options()) {
    if (option.isArgument() == arguments && !option.is_hidden && (size == HelpSize::all || !option.is_rare)) {
      const bool whole = arguments || size == HelpSize::all;
      const std::string help = whole ? option.help : option.help.substr(0, option.help.find("; "));
      text += row(option.name + placeholderOf(option), help + limitsOf(option));
    }
  }
  return text;
}

// Returns the names of the options that --help omits and --help-all shows.
std::string rareOnes(const OptionTable& table) {
  std::string names;
  for (const Option& option : table.options()) {
    if (option.is_rare && !option.is_hidden) {
      names += (names.empty() ? "" : ", ") + option.name;
    }
  }
  return names;
}

// Breaks a long call between options, with a backslash at the end of each line.
std::string callText(const std::string& call) {
  std::vector<std::string> parts;  // an option with its values
  std::istringstream words(call);
  for (std::string word; words >> word;) {
    if (parts.empty() || word[0] == '-') {
      parts.push_back(word);
    } else {
      parts.back() += " " + word;
    }
  }
  std::string text;
  std::string line = " ";
  for (const std::string& part : parts) {
    if (line.size() + part.size() + 3 > kWidth) {
      text += line + " \\\n";
      line = "     ";
    }
    line += " " + part;
  }
  return text + line + "\n";
}

std::string examplesOf(const Command& command) {
  std::string text = command.examples.empty() ? "" : "\nExamples:\n";
  for (const Example& example : command.examples) {
    text += "  # " + example.purpose + "\n" +
            callText("rosrun rubber_suspension " + command.name + " " + example.arguments);
  }
  return text;
}

std::string usage(const Command& command, const OptionTable& table) {
  std::string text = "Usage: " + command.name + " [OPTIONS]";
  for (const Option& option : table.options()) {
    if (option.isArgument()) {
      text += option.is_required ? " " + option.name : " [" + option.name + "]";
    }
  }
  return text;
}

}  // namespace

std::string numberText(double number) {
  constexpr double kLargest = 1e15;
  return number == std::floor(number) && std::abs(number) < kLargest ? fmt::format("{:.0f}", number)
                                                                     : fmt::format("{:g}", number);
}

std::string helpText(const Command& command, const OptionTable& table, HelpSize size) {
  const std::string& all = command.description;
  const std::string description = size == HelpSize::all ? all : all.substr(0, all.find("\n\n"));
  std::string text = wrapped(description, 0) + "\n" + usage(command, table) + "\n\n";
  const std::string arguments = rows(table, true, size);
  if (!arguments.empty()) {
    text += "Positionals:\n" + arguments + "\n";
  }
  text += "Options:\n" + row("-h,--help", "Print the common options and exit") +
          row("--help-all", "Print all options and exit") + row("--version", "Print the version and exit") +
          rows(table, false, size);
  const std::string rare = rareOnes(table);
  if (size == HelpSize::screen && !rare.empty()) {
    text += "  " + wrapped("With --help-all: " + rare, 2) + "\n";
  }
  return text + examplesOf(command);
}

}  // namespace rubber_suspension::command_line
