// reference: prints the reference pages of docs/, man pages and completion.
#include "io/reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "apps/command_names.h"
#include "command/help_page.h"
#include "command_line/command.h"
#include "diagnosis/report/effect_reference.h"
#include "element/each.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "ros_interface/child_process.h"
#include "ros_interface/node_interface.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

using command::HelpPage;

HelpPage helpPage(const std::string& command) {
  return command::parseHelp(command, ros_interface::outputOf(command, "--help-all"));
}

std::vector<HelpPage> helpPages() { return element::each(commandNames(), helpPage); }

std::string manPage(const std::string& command) {
  return command.empty() ? command::manPageOfAll(helpPages(), version())
                         : command::manPage(helpPage(command), version());
}

using Page = std::function<std::string()>;

const std::map<std::string, Page>& pages() {
  static const std::map<std::string, Page> table = {
      {"parameters", [] { return io::parameterReference(); }},
      {"topics", [] { return ros_interface::topicReference(); }},
      {"effects", [] { return diagnosis::report::effectReference(); }},
      {"commands", [] { return ros_interface::commandReference(commandNames()); }},
      {"list", [] { return command::commandList(helpPages()); }},
      {"completion", [] { return command::bashCompletion(helpPages()); }},
  };
  return table;
}

struct Options {
  std::string page = "parameters";
  std::string command;

  OptionTable table() {
    return {Option("page", page, "", "page to print")
                .oneOf({"parameters", "topics", "effects", "commands", "list", "completion", "man"}),
            Option("command", command, "", "with the page man: command whose page it is")};
  }
};

int print(const Options& options) {
  const std::vector<std::string> names = commandNames();
  const bool is_known = std::find(names.begin(), names.end(), options.command) != names.end();
  element::refuseIf<UsageError>(options.page != "man" && !options.command.empty(),
                                "a command goes with the page man; accepted: without it");
  if (!options.command.empty() && !is_known) {
    throw UsageError(fmt::format("no command '{}'{}; accepted: {}", options.command,
                                 element::didYouMean(options.command, names), fmt::join(names, ", ")));
  }
  std::cout << (options.page == "man" ? manPage(options.command) : pages().at(options.page)());
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"reference",
       "Prints a reference page: in Markdown that of the component file, the node, the effects or the commands; the "
       "list of the commands; completion of rubber-suspension for bash; in roff the man page of rubber-suspension or "
       "of "
       "a command.",
       {{"The page of the component file", "parameters > parameters.md"},
        {"A man page", "man replay | man -l -"},
        {"Completion for this shell", "completion > completion.bash && source completion.bash"}}},
      print);
}
