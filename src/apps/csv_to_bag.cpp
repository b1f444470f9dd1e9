// The command `csv_to_bag`: a log of any other kind as a bag with the node's topics.
#include "bag/bag_log.h"
#include "command_line/command.h"
#include "command_line/log_options.h"
#include "command_line/output_options.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  std::string component;
  std::string input;
  std::string output;
  LogOptions log_options;
  OutputOptions outputs;

  OptionTable table() {
    return {Option("--component", component, "NAME", "name of the component").required(),
            Option("--log", input, "FILE", "log to read: text (CSV), .mat or HDF5").required(),
            Option("--output", output, "FILE", "bag to write").required(), log_options.table(), outputs.table()};
  }
};

int convert(const Options& options) {
  options.outputs.check({{"--log", options.input}}, {{"--output", options.output, io::FileKind::bag}});
  if (bag::isBagPath(options.input)) {
    throw UsageError("--log: " + options.input + " is a bag already; accepted: text (CSV), .mat or HDF5");
  }
  const log::Log log = options.log_options.read("csv_to_bag", options.input, options.component);
  bag::writeBagLog(options.output, options.component, log);
  std::cout << options.output << ": " << log.size() << " samples of " << options.component
            << (log.force.empty() ? ", displacement\n" : ", displacement and measured force\n");
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return runCommand(argc, argv,
                    {"csv_to_bag",
                     "Writes a log as a bag with the topics <component>/displacement and "
                     "<component>/measured_force."},
                    options.table(), [&] { return convert(options); });
}
