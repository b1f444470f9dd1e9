// The command `csv_to_bag`: a log of any other kind as a bag with the node's topics.
#include <memory>

#include "apps/command.h"
#include "apps/log_options.h"
#include "apps/output_options.h"
#include "bag/bag_log.h"

using namespace rubber_suspension;
using namespace rubber_suspension::apps;

namespace {

struct Options {
  std::string component;
  std::string input;
  std::string output;
  LogOptions log_options;
  OutputOptions outputs;
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
  return runCommand(
      argc, argv, "csv_to_bag",
      "Writes a log as a bag with the topics <component>/displacement and "
      "<component>/measured_force.",
      [](CLI::App& app) {
        const auto options = std::make_shared<Options>();
        app.add_option("--component", options->component, "name of the component")->required()->type_name("NAME");
        app.add_option("--log", options->input, "log to read: text (CSV), .mat or HDF5")->required()->type_name("FILE");
        app.add_option("--output", options->output, "bag to write")->required()->type_name("FILE");
        options->log_options.addTo(app);
        options->outputs.addTo(app);
        return [options] { return convert(*options); };
      });
}
