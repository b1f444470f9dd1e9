// From the text of --help-all to pages and completion.
#include "command/help_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "element/each.h"
#include "log/text.h"

namespace rubber_suspension::command {
namespace {

constexpr const char* kProgram = "rubber-suspension";

using log::startsWith;

// Two blanks and a word: an option; more blanks continue the one before.
bool isOption(const std::string& line) { return startsWith(line, "  ") && line.size() > 2 && line[2] != ' '; }

HelpOption parseOption(const std::string& line) {
  const std::size_t end = std::min(line.find("  ", 2), line.size());
  std::istringstream words(line.substr(2, end - 2));
  HelpOption option;
  std::string names;
  words >> names;
  std::getline(words, option.placeholder);
  option.placeholder = log::trimmed(option.placeholder);
  option.text = log::trimmed(line.substr(end));
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    option.names.push_back(name);
  }
  return option;
}

// Text in roff: no hyphen is taken for a dash, no line for a request.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  const bool request = !result.empty() && (result[0] == '.' || result[0] == '\'');
  return request ? "\\&" + result : result;
}

std::string header(const std::string& name, const std::string& version) {
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return std::toupper(c); });
  return fmt::format(".TH {} 1 \"\" \"rubber_suspension {}\" \"User Commands\"\n", roff(title), version);
}

// A sentence as it stands in a list: no capital, no full stop.
std::string asPhrase(std::string sentence) {
  if (!sentence.empty()) {
    sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
    sentence.erase(sentence.find_last_not_of('.') + 1);
  }
  return sentence;
}

// Lines that are laid out stay as they are.
std::string descriptionInRoff(const std::vector<std::string>& lines) {
  std::string text;
  bool laid_out = false;
  for (const std::string& line : lines) {
    const bool keeps = startsWith(line, " ");
    text += keeps == laid_out ? "" : (keeps ? ".nf\n" : ".fi\n");
    laid_out = keeps;
    text += line.empty() ? ".PP\n" : roff(line) + "\n";
  }
  return text + (laid_out ? ".fi\n" : "");
}

std::string optionInRoff(const HelpOption& option) {
  const auto bold = [](const std::string& name) { return "\\fB" + roff(name) + "\\fR"; };
  return fmt::format(".TP\n{}{}\n{}\n", element::joined(option.names, ", ", bold),
                     option.placeholder.empty() ? "" : " \\fI" + roff(option.placeholder) + "\\fR", roff(option.text));
}

constexpr const char* kExitStatus =
    ".SH EXIT STATUS\n0, or 1 where the data could not be used, or 2 on wrong options; errors are one line on the "
    "standard error.\n";

// The long names of the options that take such a value.
std::string namesWith(const HelpPage& page, const std::string& placeholder) {
  const auto with =
      element::those(page.options, [&](const auto& option) { return startsWith(option.placeholder, placeholder); });
  return element::joined(with, " ", [](const HelpOption& option) { return option.names.back(); });
}

std::string longNames(const HelpPage& page) {
  std::vector<std::string> names;
  for (const HelpOption& option : page.options) {
    std::copy_if(option.names.begin(), option.names.end(), std::back_inserter(names),
                 [](const std::string& name) { return startsWith(name, "--"); });
  }
  return fmt::format("{}", fmt::join(names, " "));
}

// The body of the function; a command that is not in the tables, as the Python scripts, is asked itself.
constexpr const char* kCompletion =
    R"bash(    *) options=$("${COMP_WORDS[@]:0:2}" --help 2>/dev/null | grep -oE -- '--[a-z][a-z-]*' | sort -u) ;;
  esac
  # An option may have several values: the one that the word belongs to is the last before it.
  local i option=
  for ((i = COMP_CWORD - 1; i > 1; --i)); do
    [[ ${COMP_WORDS[i]} == -* ]] && { option=${COMP_WORDS[i]}; break; }
  done
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  elif [[ " $folders " == *" $option "* ]]; then
    compopt -o filenames
    COMPREPLY=($(compgen -d -- "$word"))
  elif [[ $option == --component ]]; then
    local config=
    for ((i = 2; i < COMP_CWORD; ++i)); do
      [[ ${COMP_WORDS[i]} == --config ]] && config=${COMP_WORDS[i + 1]}
    done
    COMPREPLY=($(compgen -W "$(sed -nE 's/^  ([A-Za-z][A-Za-z0-9_]*):.*/\1/p' "$config" 2>/dev/null)" -- "$word"))
  elif [[ -z $option || " $files " == *" $option "* ]]; then
    compopt -o filenames
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -F _rubber_suspension rubber-suspension

# rosrun rubber_suspension COMMAND as rubber-suspension COMMAND; all else as rosbash has it, which bash may not have loaded.
_rubber_suspension_rosrun() {
  if [ "$COMP_CWORD" -gt 2 ] && [ "${COMP_WORDS[1]}" = rubber_suspension ]; then
    local COMP_WORDS=(rubber-suspension "${COMP_WORDS[@]:2}") COMP_CWORD=$((COMP_CWORD - 1))
    _rubber_suspension
  else
    if ! declare -F _roscomplete_exe >/dev/null && [ -r /usr/share/bash-completion/completions/rosrun ]; then
      . /usr/share/bash-completion/completions/rosrun
      complete -F _rubber_suspension_rosrun rosrun
    fi
    ! declare -F _roscomplete_exe >/dev/null || _roscomplete_exe
  fi
}
complete -F _rubber_suspension_rosrun rosrun
)bash";

}  // namespace

std::string HelpPage::firstSentence() const {
  std::string text;
  for (const std::string& line : description) {
    if (line.empty()) {
      break;
    }
    text += (text.empty() ? "" : " ") + line;
  }
  const std::size_t end = text.find(". ");
  return end == std::string::npos ? text : text.substr(0, end + 1);
}

HelpPage parseHelp(const std::string& command, const std::string& text) {
  HelpPage page;
  page.command = command;
  const std::string usage = fmt::format("Usage: {}", command);
  bool described = false;
  bool in_examples = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (in_examples) {
      page.examples.push_back(line);
    } else if (described && line == "Examples:") {
      in_examples = true;
    } else if (startsWith(line, usage)) {
      described = true;
      page.usage = log::trimmed(line.substr(usage.size()));
    } else if (!described) {
      page.description.push_back(line);
    } else if (isOption(line)) {
      page.options.push_back(parseOption(line));
    } else if (startsWith(line, "   ") && !page.options.empty()) {
      std::string& described_option = page.options.back().text;
      described_option += (described_option.empty() ? "" : " ") + log::trimmed(line);
    }
  }
  return page;
}

std::string commandList(const std::vector<HelpPage>& pages) {
  constexpr std::size_t kWidth = 100;
  constexpr std::size_t kIndent = 20;
  std::string text;
  for (const HelpPage& page : pages) {
    std::string line = fmt::format("  {:<{}}", page.command, kIndent - 2);
    std::istringstream words(asPhrase(page.firstSentence()));
    for (std::string word; words >> word;) {
      if (line.size() + word.size() + 1 > kWidth) {
        text += line + "\n";
        line = std::string(kIndent, ' ');
      }
      line += (line.back() == ' ' ? "" : " ") + word;
    }
    text += line + "\n";
  }
  return text;
}

std::string manPage(const HelpPage& page, const std::string& version) {
  const std::string name = fmt::format("{}-{}", kProgram, page.command);
  std::string text = header(name, version);
  text += fmt::format(".SH NAME\n{} \\- {}\n", roff(name), roff(asPhrase(page.firstSentence())));
  text += fmt::format(".SH SYNOPSIS\n.B {} {}\n{}\n", roff(kProgram), roff(page.command), roff(page.usage));
  text += ".SH DESCRIPTION\n" + descriptionInRoff(page.description) + ".SH OPTIONS\n";
  text += element::joined(page.options, "", optionInRoff);
  if (!page.examples.empty()) {
    text += ".SH EXAMPLES\n" + descriptionInRoff(page.examples);
  }
  return text + kExitStatus + fmt::format(".SH SEE ALSO\n.BR {} (1)\n", roff(kProgram));
}

std::string manPageOfAll(const std::vector<HelpPage>& pages, const std::string& version) {
  std::string text = header(kProgram, version);
  text += fmt::format(
      ".SH NAME\n{0} \\- simulates rubber components of vehicle suspensions and diagnoses the gap to measured logs\n"
      ".SH SYNOPSIS\n.B {0}\n.I COMMAND\n[OPTIONS]\n.SH DESCRIPTION\nRuns a command of the package "
      "rubber_suspension, as rosrun does, without looking for the package first.\n.SH COMMANDS\n",
      roff(kProgram));
  for (const HelpPage& page : pages) {
    text += fmt::format(".TP\n.BR {}\\-{} (1)\n{}\n", roff(kProgram), roff(page.command),
                        roff(asPhrase(page.firstSentence())));
  }
  return text + kExitStatus;
}

std::string bashCompletion(const std::vector<HelpPage>& pages) {
  std::string text = fmt::format(
      "# Completion of rubber-suspension for bash, written by its command `reference`.\n"
      "_rubber_suspension() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} command=${{COMP_WORDS[1]-}} options= files= folders=\n"
      "  COMPREPLY=()\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W \"{} generate_track live_plot --help --version\" -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case $command in\n",
      element::joined(pages, " ", &HelpPage::command));
  for (const HelpPage& page : pages) {
    text += fmt::format("    {}) options=\"{}\" files=\"{}\" folders=\"{}\" ;;\n", page.command, longNames(page),
                        namesWith(page, "FILE"), namesWith(page, "FOLDER"));
  }
  return text + kCompletion;
}

}  // namespace rubber_suspension::command
