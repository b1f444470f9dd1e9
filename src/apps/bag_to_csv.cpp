// The command `bag_to_csv`: one component's displacement and measured force of a bag as a CSV log.
#include <memory>

#include "apps/command.h"
#include "apps/output_options.h"
#include "bag/bag_log.h"

using namespace rubber_suspension;
using namespace rubber_suspension::apps;

namespace {

struct Options {
  std::string component;
  std::string input;
  std::string output;
  OutputOptions outputs;
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
  return runCommand(argc, argv, "bag_to_csv",
                    "Writes one component's displacement and, if recorded, measured force of a bag as a CSV log.",
                    [](CLI::App& app) {
                      const auto options = std::make_shared<Options>();
                      app.add_option("--component", options->component,
                                     "name of the component; may be left out where "
                                     "the bag has only one")
                          ->type_name("NAME");
                      app.add_option("--log", options->input, "bag to read")->required()->type_name("FILE");
                      app.add_option("--output", options->output, "CSV file to write")->required()->type_name("FILE");
                      options->outputs.addTo(app);
                      return [options] { return convert(*options); };
                    });
}
