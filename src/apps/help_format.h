// How every command prints its --help: lines of a terminal's width, the range and default of a value behind its
// meaning.
#pragma once

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>

namespace rubber_suspension::apps {

class HelpFormat final : public CLI::Formatter {
 public:
  std::string make_description(const CLI::App* app) const override { return wrapped(app->get_description(), 0) + "\n"; }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const Value value = valueOf(*option);
    const std::string name = is_positional ? option->get_name(true) : option->get_name(false, true);
    std::string line = "  " + name + (is_positional ? "" : value.placeholder);
    line += line.size() + 2 > kIndent ? "\n" + std::string(kIndent, ' ') : std::string(kIndent - line.size(), ' ');
    return line + wrapped(option->get_description() + value.limits, kIndent) + "\n";
  }

 private:
  static constexpr std::size_t kWidth = 100;
  static constexpr std::size_t kIndent = 28;

  struct Value {
    std::string placeholder;  // " SECONDS", nothing for a flag
    std::string limits;       // " (1 to 64; default 2)"
  };

  // The parser's name of a type is that given to the option and, behind a colon, what its checks accept.
  static Value valueOf(const CLI::Option& option) {
    if (option.get_type_size() == 0) {
      return {};
    }
    const std::string type = option.get_type_name();
    const std::size_t colon = type.find_first_of("[{") == std::string::npos ? std::string::npos : type.find(':');
    const std::string accepted = colon == std::string::npos ? "" : type.substr(colon + 1);
    const std::string word = " " + type.substr(0, colon);
    Value value{word, ""};
    if (option.get_expected_max() > 1) {
      value.placeholder += option.get_expected_min() == option.get_expected_max() ? word : " ...";
    }
    std::string limits = option.get_required() ? "required" : "";
    const auto add = [&](const std::string& text) { limits += (limits.empty() ? "" : "; ") + text; };
    if (!accepted.empty()) {
      add(readable(accepted));
    }
    if (!option.get_default_str().empty()) {
      add("default " + option.get_default_str());
    }
    value.limits = limits.empty() ? "" : " (" + limits + ")";
    return value;
  }

  // "FLOAT in [0 - 1]" as "0 to 1", "{a,b}" as "a, b".
  static std::string readable(const std::string& accepted) {
    const std::size_t open = accepted.find_first_of("[{");
    if (open == std::string::npos) {
      return accepted;
    }
    const bool is_range = accepted[open] == '[';
    std::string text = accepted.substr(open + 1, accepted.size() - open - 2);
    const std::string separator = is_range ? " - " : ",";
    const std::string replacement = is_range ? " to " : ", ";
    for (std::size_t at = 0; (at = text.find(separator, at)) != std::string::npos; at += replacement.size()) {
      text.replace(at, separator.size(), replacement);
    }
    return text;
  }

  // Lines that begin with blanks are laid out already, but for their length; what follows is set below their last word.
  static std::string wrapped(const std::string& text, std::size_t indent) {
    std::string result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      result += (result.empty() ? "" : "\n" + std::string(indent, ' ')) + wrappedLine(line, indent);
    }
    return result;
  }

  static std::string wrappedLine(const std::string& line, std::size_t indent) {
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
};

}  // namespace rubber_suspension::apps
