// The help of a command.
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

// Lines that begin with blanks are laid out already, but for their length; what follows is set below their last word.
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

// A number that is not admissible, or text that is empty, stands for "not given".
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

// " (1 to 64; default 2)".
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
  const std::string word = " " + option.placeholder;
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

std::string rows(const OptionTable& table, bool arguments) {
  std::string text;
  for (const Option& option : table.options()) {
    if (option.isArgument() == arguments && !option.is_hidden) {
      text += row(option.name + placeholderOf(option), option.help + limitsOf(option));
    }
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

std::string helpText(const Command& command, const OptionTable& table) {
  std::string text = wrapped(command.description, 0) + "\n" + usage(command, table) + "\n\n";
  const std::string arguments = rows(table, true);
  if (!arguments.empty()) {
    text += "Positionals:\n" + arguments + "\n";
  }
  return text + "Options:\n" + row("-h,--help", "Print this help message and exit") +
         row("--version", "Print the version and exit") + rows(table, false);
}

}  // namespace rubber_suspension::command_line
