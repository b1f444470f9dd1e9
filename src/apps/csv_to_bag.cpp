// The command `csv_to_bag` writes a log of any other format as a bag with the node's topics.
#include "bag/bag_log.h"
#include "command_line/command.h"
#include "command_line/log_options.h"
#include "element/refuse.h"
#include "io/progress.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  std::string component;
  std::string input;
  std::string output;
  LogOptions log_options;

  OptionTable table() {
    return {Option("--component", component, "NAME", "name of the component").required(),
            Option("--log", input, "FILE", "log to read: text (CSV), .mat or HDF5").required().reads(),
            Option("--output", output, "FILE", "bag to write").required().writes(io::file_kind::bag),
            log_options.table()};
  }
};

int convert(const Options& options) {
  element::refuseIf<UsageError>(bag::isBagPath(options.input),
                                "--log: {} is already a bag; accepted: text (CSV), .mat or HDF5", options.input);
  const log::Log log = options.log_options.read("csv_to_bag", options.input, options.component);
  const io::Activity writing("writing " + options.output);
  bag::writeBagLog(options.output, options.component, log);
  std::cout << options.output << ": " << log.size() << " samples of " << options.component
            << (log.force.empty() ? ", displacement\n" : ", displacement and measured force\n");
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"csv_to_bag",
       "Writes a log as a bag with the topics <component>/displacement and "
       "<component>/measured_force.",
       {{"A log with a header", "--component bush --log log.csv --output run.bag"},
        {"Columns without names, in mm and kN",
         "--component bush --log raw.csv --columns time displacement force --unit displacement=mm "
         "force=kN --output raw.bag"},
        {"A log without times, at 2 kHz",
         "--component bush --log untimed.csv --sampling-rate '2 kHz' --output untimed.bag"}}},
      convert);
}
