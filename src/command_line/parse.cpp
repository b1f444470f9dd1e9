// Parses command lines with CLI11. No other file includes CLI11, which takes long to compile.
#include "command_line/parse.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <deque>

#include "command_line/command.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::command_line {
namespace {

struct VersionRequest {};

// Returns the error if a text is not a number within the bounds; otherwise an empty text.
std::string outOfBounds(const Option& option, const std::string& text) {
  const auto [lowest, highest] = *option.bounds;
  const std::optional<double> number = log::parseNumber(text);
  const bool real = std::holds_alternative<double*>(option.target);
  if (number && *number >= lowest && *number <= highest && (real || *number == std::floor(*number))) {
    return "";
  }
  return fmt::format("{} is not valid; accepted: {} from {} to {}", log::quoted(text),
                     real ? "a number" : "a whole number", numberText(lowest), numberText(highest));
}

// Returns for example "a, b or c".
std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  }
  return text;
}

class Parser {
 public:
  Parser(const Command& command, const OptionTable& table) : table_(table), app_(command.description, command.name) {
    app_.set_help_flag("-h,--help");
    app_.set_help_all_flag("--help-all");
    app_.add_flag_callback("--version", [] { throw VersionRequest(); });
    for (const Option& option : table.options()) {
      constrain(option, *std::visit([&](const auto& target) { return add(option, target); }, option.target));
    }
  }

  Request parse(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::CallForAllHelp&) {
      return Request::help_all;
    } catch (const CLI::Success&) {
      return Request::help;
    } catch (const VersionRequest&) {
      return Request::version;
    } catch (const CLI::ParseError& error) {
      // A misspelt option is reported first, because it may be the reason why a required option is missing.
      const std::string unknown = unknownOption();
      throw UsageError(unknown.empty() ? std::string(error.what()) + " (see --help)" : unknown);
    }
    for (const Rule& rule : table_.rules()) {
      check(rule);
    }
    readQuantities();
    return Request::run;
  }

 private:
  struct QuantityTexts {
    const Option* option;
    std::vector<std::string> texts;
  };

  CLI::Option* add(const Option& option, bool* flag) { return app_.add_flag(option.name, *flag); }

  // Stores the text of a quantity. It is converted after the rules have been checked.
  CLI::Option* add(const Option& option, const Quantity& /*quantity*/) {
    quantities_.push_back({&option, {}});
    CLI::Option* parsed = app_.add_option(option.name, quantities_.back().texts);
    return option.most_values == 1 ? parsed->expected(1) : parsed;
  }

  template <class T>
  CLI::Option* add(const Option& option, T* value) {
    return app_.add_option(option.name, *value);
  }

  void constrain(const Option& option, CLI::Option& parsed) {
    parsed.required(option.is_required);
    if (option.most_values > 1 && option.most_values < Option::kAny) {
      parsed.expected(option.least_values, option.most_values);
    }
    if (option.bounds) {
      parsed.check([&option](const std::string& text) { return outOfBounds(option, text); });
    }
    if (option.placeholder == "FILE" || option.placeholder == "FOLDER") {
      parsed.check(
          [](const std::string& text) { return text.empty() ? "the name is empty; accepted: a file name" : ""; });
    }
    if (option.problem) {
      parsed.check(option.problem);
    }
    if (!option.words.empty()) {
      parsed.check(CLI::IsMember(option.words));
    }
  }

  std::string unknownOption() const {
    std::vector<std::string> names = {"help", "help-all", "version"};
    for (const Option& option : table_.options()) {
      if (!option.isArgument() && !option.is_hidden) {
        names.push_back(option.name.substr(2));
      }
    }
    for (const std::string& word : app_.remaining()) {
      const std::string given = word.substr(0, word.find('='));
      if (given.rfind("--", 0) == 0) {
        const auto meant = element::nearestWord(given.substr(2), names);
        return "no option " + given + (meant ? " (did you mean --" + *meant + "?)" : "") +
               "; accepted: the options listed by --help";
      }
    }
    const bool lacks_config = std::find(names.begin(), names.end(), "config") != names.end() && !isGiven("--config");
    return lacks_config && !app_.remaining().empty()
               ? app_.remaining().front() + ": the option is missing; accepted: --config " + app_.remaining().front()
               : "";
  }

  bool isGiven(const std::string& option) const { return app_.count(option) > 0; }

  // Returns the value of a text option, which may be its default.
  const std::string& textOf(const std::string& name) const {
    const auto found = std::find_if(table_.options().begin(), table_.options().end(),
                                    [&](const Option& option) { return option.name == name; });
    return *std::get<std::string*>(found->target);
  }

  bool holds(const std::string& condition) const {
    const std::size_t blank = condition.find(' ');
    return blank == std::string::npos ? isGiven(condition)
                                      : textOf(condition.substr(0, blank)) == condition.substr(blank + 1);
  }

  // Returns " with --plan", or " on run" if the condition concerns a positional argument.
  std::string reason(const std::string& preposition, const std::vector<std::string>& conditions) const {
    const std::string& first = conditions.front();
    return first[0] == '-' ? " " + preposition + " " + alternatives(conditions)
                           : " on " + textOf(first.substr(0, first.find(' ')));
  }

  // Throws UsageError if one of these options is given, because it has no effect.
  void refuseGiven(const std::vector<std::string>& options, const std::string& why) const {
    for (const std::string& option : options) {
      element::refuseIf<UsageError>(isGiven(option), "{} has no effect{}", option, why);
    }
  }

  void check(const Rule& rule) const {
    const auto holding = std::find_if(rule.conditions.begin(), rule.conditions.end(),
                                      [&](const std::string& condition) { return holds(condition); });
    const bool any = holding != rule.conditions.end();
    if (rule.kind == Rule::Kind::needs && !any) {
      refuseGiven(rule.options, reason("without", rule.conditions));
    } else if (rule.kind == Rule::Kind::excludes && any) {
      refuseGiven(rule.options, reason("with", {*holding}));
    } else if (rule.kind == Rule::Kind::one_of &&
               std::count_if(rule.options.begin(), rule.options.end(),
                             [&](const std::string& option) { return isGiven(option); }) != 1) {
      throw UsageError(fmt::format("accepted: exactly one of {} (see --help)", fmt::join(rule.options, " and ")));
    }
  }

  void readQuantities() const {
    for (const QuantityTexts& read : quantities_) {
      const Quantity& quantity = std::get<Quantity>(read.option->target);
      std::vector<double> values;
      for (const std::string& text : read.texts) {
        values.push_back(quantityOf(read.option->name, text, quantity));
      }
      if (!values.empty()) {
        std::visit([&](auto* target) { assign(*target, values); }, quantity.value);
      }
    }
  }

  static void assign(std::vector<double>& target, const std::vector<double>& values) { target = values; }

  template <class T>
  static void assign(T& target, const std::vector<double>& values) {
    target = values.front();
  }

  const OptionTable& table_;
  CLI::App app_;
  std::deque<QuantityTexts> quantities_;
};

}  // namespace

Request parse(int argc, char** argv, const Command& command, const OptionTable& table) {
  return Parser(command, table).parse(argc, argv);
}

}  // namespace rubber_suspension::command_line
