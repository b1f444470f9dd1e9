// reference: prints the reference pages of docs/, man pages and completion.
#include "io/reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <sstream>

#include "apps/command.h"
#include "command/help_page.h"
#include "diagnosis/report/effect_reference.h"
#include "element/suggestion.h"
#include "ros_interface/command_reference.h"
#include "ros_interface/node_interface.h"

namespace {

std::vector<std::string> commandNames() {
  std::istringstream words(RUBBER_SUSPENSION_COMMANDS);
  std::vector<std::string> names;
  for (std::string name; words >> name;) {
    names.push_back(name);
  }
  return names;
}

using rubber_suspension::command::HelpPage;

HelpPage helpPage(const std::string& command) {
  const auto help = rubber_suspension::ros_interface::outputOf(command, "--help");
  if (help.status != 0) {
    throw std::runtime_error(fmt::format("{} --help: exit status {}", command, help.status));
  }
  return rubber_suspension::command::parseHelp(command, help.text);
}

std::vector<HelpPage> helpPages() {
  std::vector<HelpPage> pages;
  for (const std::string& name : commandNames()) {
    pages.push_back(helpPage(name));
  }
  return pages;
}

std::string manPage(const std::string& command) {
  return command.empty() ? rubber_suspension::command::manPageOfAll(helpPages(), RUBBER_SUSPENSION_VERSION)
                         : rubber_suspension::command::manPage(helpPage(command), RUBBER_SUSPENSION_VERSION);
}

using Page = std::function<std::string()>;

const std::map<std::string, Page>& pages() {
  static const std::map<std::string, Page> table = {
      {"parameters", [] { return rubber_suspension::io::parameterReference(); }},
      {"topics", [] { return rubber_suspension::ros_interface::topicReference(); }},
      {"effects", [] { return rubber_suspension::diagnosis::effectReference(); }},
      {"commands", [] { return rubber_suspension::ros_interface::commandReference(commandNames()); }},
      {"list", [] { return rubber_suspension::command::commandList(helpPages()); }},
      {"completion", [] { return rubber_suspension::command::bashCompletion(helpPages()); }},
  };
  return table;
}

struct Options {
  std::string page = "parameters";
  std::string command;
};

int print(const Options& options) {
  const std::vector<std::string> names = commandNames();
  const bool is_known = std::find(names.begin(), names.end(), options.command) != names.end();
  if (options.page != "man" && !options.command.empty()) {
    throw rubber_suspension::apps::UsageError("a command goes with the page man; accepted: without it");
  }
  if (!options.command.empty() && !is_known) {
    throw rubber_suspension::apps::UsageError(
        fmt::format("no command '{}'{}; accepted: {}", options.command,
                    rubber_suspension::element::didYouMean(options.command, names), fmt::join(names, ", ")));
  }
  std::cout << (options.page == "man" ? manPage(options.command) : pages().at(options.page)());
  return rubber_suspension::apps::kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace rubber_suspension;
  using namespace rubber_suspension::apps;
  return runCommand(
      argc, argv, "reference",
      "Prints a reference page: in Markdown that of the component file, the node, the effects or the commands; the "
      "list of the commands; completion of rubber-suspension for bash; in roff the man page of rubber-suspension or of "
      "a command.",
      [](CLI::App& app) -> CommandBody {
        const auto options = std::make_shared<Options>();
        app.add_option("page", options->page, "page to print")
            ->check(CLI::IsMember({"parameters", "topics", "effects", "commands", "list", "completion", "man"}))
            ->capture_default_str();
        app.add_option("command", options->command, "with the page man: command whose page it is");
        return [options] { return print(*options); };
      });
}
