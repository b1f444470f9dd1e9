// reference: prints the reference pages of docs/.
#include "io/reference.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <sstream>

#include "apps/command.h"
#include "diagnosis/report/effect_reference.h"
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

using Page = std::function<std::string()>;

const std::map<std::string, Page>& pages() {
  static const std::map<std::string, Page> table = {
      {"parameters", [] { return rubber_suspension::io::parameterReference(); }},
      {"topics", [] { return rubber_suspension::ros_interface::topicReference(); }},
      {"effects", [] { return rubber_suspension::diagnosis::effectReference(); }},
      {"commands", [] { return rubber_suspension::ros_interface::commandReference(commandNames()); }},
  };
  return table;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace rubber_suspension;
  using namespace rubber_suspension::apps;
  return runCommand(
      argc, argv, "reference",
      "Prints a reference page as Markdown: of the component file, the node, the effects or the commands.",
      [](CLI::App& app) -> CommandBody {
        const auto page = std::make_shared<std::string>("parameters");
        app.add_option("page", *page, "page to print")
            ->check(CLI::IsMember({"parameters", "topics", "effects", "commands"}))
            ->capture_default_str();
        return [page] {
          std::cout << pages().at(*page)();
          return static_cast<int>(kSuccess);
        };
      });
}
