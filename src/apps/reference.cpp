// The command `reference` prints the pages of docs/ that are generated from the code.
#include "io/reference.h"

#include "command_line/command.h"
#include "diagnosis/report/effect_reference.h"
#include "ros_interface/node_interface.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  std::string page = "parameters";

  OptionTable table() { return {Option("page", page, "", "page to print").oneOf({"parameters", "topics", "effects"})}; }
};

int print(const Options& options) {
  std::cout << (options.page == "topics"    ? ros_interface::topicReference()
                : options.page == "effects" ? diagnosis::report::effectReference()
                                            : io::parameterReference());
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"reference",
       "Prints a reference page in Markdown: that of the component file, the node or the effects.",
       {{"The page of the component file", "parameters > parameters.md"},
        {"The page of the node", "topics > topics.md"},
        {"The page of the effects that a diagnosis names", "effects > effects.md"}}},
      print);
}
