// The command `bag_to_csv`: one component's displacement and measured force of a bag as a CSV log.
#include "bag/bag_log.h"
#include "command_line/command.h"
#include "command_line/output_options.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  std::string component;
  std::string input;
  std::string output;
  OutputOptions outputs;

  OptionTable table() {
    return {
        Option("--component", component, "NAME", "name of the component; may be left out where the bag has only one"),
        Option("--log", input, "FILE", "bag to read").required(),
        Option("--output", output, "FILE", "CSV file to write").required(), outputs.table()};
  }
};

int convert(const Options& options) {
  options.outputs.check({{"--log", options.input}}, {{"--output", options.output, io::FileKind::force_csv}});
  const log::Log log = bag::readBagLog(options.input, options.component);
  for (const std::string& note : log.notes) {
    printNote("bag_to_csv", note);
  }
  log::writeLogCsv(options.output, log);
  std::cout << options.output << ": " << log.size() << " samples"
            << (log.force.empty() ? ", displacement\n" : ", displacement and measured force\n");
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return runCommand(
      argc, argv,
      {"bag_to_csv", "Writes one component's displacement and, if recorded, measured force of a bag as a CSV log."},
      options.table(), [&] { return convert(options); });
}
