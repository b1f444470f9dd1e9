// The command `bag_to_csv` writes displacement and measured force of one component in a bag as a CSV log.
#include "bag/bag_log.h"
#include "command_line/command.h"
#include "io/progress.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  std::string component;
  std::string input;
  std::string output;

  OptionTable table() {
    return {Option("--component", component, "NAME", "name of the component; needed if the bag has several components"),
            Option("--log", input, "FILE", "bag to read").required().reads(),
            Option("--output", output, "FILE", "CSV file to write").required().writes(io::file_kind::force_csv)};
  }
};

int convert(const Options& options) {
  const io::Activity converting("converting " + options.input);
  const log::Log log = bag::readBagLog(options.input, options.component);
  printNotes("bag_to_csv", log.notes);
  log::writeLogCsv(options.output, log);
  std::cout << options.output << ": " << log.size() << " samples"
            << (log.force.empty() ? ", displacement\n" : ", displacement and measured force\n");
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"bag_to_csv",
       "Writes the displacement and, if recorded, the measured force of one component of a bag as a CSV log.",
       {{"The only component of a bag", "--log run.bag --output run.csv"},
        {"One of several components", "--log run.bag --component bush --output bush.csv"},
        {"For another program", "--log run.bag --output /dev/stdout | head"}}},
      convert);
}
