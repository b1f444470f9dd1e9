// The command `csv_to_bag`: a CSV log as a bag with the node's topics.
#include <memory>

#include "command.h"
#include "rubber_suspension/ros_interface/bag_log.h"

using namespace rubber_suspension;

namespace {

struct Options {
  std::string component;
  std::string input;
  std::string output;
};

int convert(const Options& options) {
  const Log log = readCsvLog(options.input);
  for (const std::string& note : log.notes) {
    std::cerr << "csv_to_bag: note: " << note << '\n';
  }
  writeBagLog(options.output, options.component, log);
  std::cout << options.output << ": " << log.size() << " samples of " << options.component
            << (log.force.empty() ? ", displacement\n" : ", displacement and measured force\n");
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand(argc, argv, "csv_to_bag",
                    "Write a CSV log as a bag with the topics <component>/displacement and "
                    "<component>/measured_force.",
                    [](CLI::App& app) {
                      const auto options = std::make_shared<Options>();
                      app.add_option("--component", options->component, "name of the component")->required();
                      app.add_option("--log", options->input, "CSV file")->required();
                      app.add_option("--output", options->output, "bag to write")->required();
                      return [options] { return convert(*options); };
                    });
}
