// export_bushing: writes a component as a bushing property file of Adams.
#include <fmt/format.h>

#include "command/bushing_file.h"
#include "command_line/command.h"
#include "command_line/component_options.h"
#include "command_line/output_options.h"
#include "log/new_file.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

struct Options {
  ComponentOptions component;
  std::string output;
  std::string axis = "z";
  command::BushingFileOptions bushing;
  OutputOptions outputs;

  OptionTable table() {
    return {component.table(),
            Option("--output", output, "FILE", "file to write").required(),
            Option("--largest-displacement", Quantity{&bushing.largest_displacement, "m"}, "METRES",
                   "the curve goes as far to both sides, such as '10 mm'")
                .required(),
            Option("--frequency", Quantity{&bushing.frequency, "Hz"}, "HZ",
                   "frequency of the sine whose loss the damping has")
                .required(),
            Option("--amplitude", Quantity{&bushing.amplitude, "m"}, "METRES", "amplitude of this sine, such as '1 mm'")
                .required(),
            Option("--axis", axis, "AXIS", "axis of the bushing that the component is along: x, y or z")
                .oneOf({"x", "y", "z"}),
            Option("--points", bushing.points, "COUNT", "points of the curve, an odd number").within(3, 100001),
            outputs.table()};
  }
};

int run(const Options& options) {
  command::BushingFileOptions bushing = options.bushing;
  bushing.axis = options.axis.front();
  if (bushing.points % 2 == 0) {
    throw UsageError(
        fmt::format("--points: {} is even; accepted: an odd number, so that 0 is on the curve", bushing.points));
  }
  options.outputs.check({{"--config", options.component.config}},
                        {{"--output", options.output, io::FileKind::bushing_file}});
  const io::ComponentDescription description = options.component.read("export_bushing");
  const command::BushingFile file = command::makeBushingFile(description.name, description.makeComponent(), bushing);
  log::writeNewFile(options.output, file.text);
  for (const std::string& note : file.notes) {
    printNote("export_bushing", note);
  }
  std::cout << options.output << '\n';
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return runCommand(argc, argv,
                    {"export_bushing",
                     "Writes a component as a bushing property file (.bus) of Adams: static curve and one constant of "
                     "damping; tells what the format cannot say of it."},
                    options.table(), [&] { return run(options); });
}
