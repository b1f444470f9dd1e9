// export_bushing: writes a component as a bushing property file of Adams.
#include <fmt/format.h>

#include <memory>

#include "apps/command.h"
#include "apps/component_options.h"
#include "apps/output_options.h"
#include "apps/quantity_option.h"
#include "command/bushing_file.h"
#include "log/new_file.h"
#include "rubber_suspension/io/component_file.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::apps;

struct Options {
  ComponentOptions component;
  std::string output;
  std::string axis = "z";
  std::string largest_displacement;
  std::string frequency;
  std::string amplitude;
  int points = command::BushingFileOptions().points;
  OutputOptions outputs;
};

double positive(const std::string& option, const std::string& text, const std::string& unit) {
  return quantityOf(option, text, unit, element::Range::positive());
}

int run(const Options& options) {
  command::BushingFileOptions bushing;
  bushing.axis = options.axis.front();
  bushing.largest_displacement = positive("--largest-displacement", options.largest_displacement, "m");
  bushing.frequency = positive("--frequency", options.frequency, "Hz");
  bushing.amplitude = positive("--amplitude", options.amplitude, "m");
  bushing.points = options.points;
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
  return runCommand(
      argc, argv, "export_bushing",
      "Writes a component as a bushing property file (.bus) of Adams: static curve and one constant of damping; tells "
      "what the format cannot say of it.",
      [](CLI::App& app) -> CommandBody {
        auto options = std::make_shared<Options>();
        options->component.addTo(app);
        app.add_option("--output", options->output, "file to write")->required()->type_name("FILE");
        app.add_option("--largest-displacement", options->largest_displacement,
                       "the curve goes as far to both sides, such as '10 mm'")
            ->required()
            ->type_name("METRES");
        app.add_option("--frequency", options->frequency, "frequency of the sine whose loss the damping has")
            ->required()
            ->type_name("HZ");
        app.add_option("--amplitude", options->amplitude, "amplitude of this sine, such as '1 mm'")
            ->required()
            ->type_name("METRES");
        app.add_option("--axis", options->axis, "axis of the bushing that the component is along: x, y or z")
            ->type_name("AXIS")
            ->capture_default_str()
            ->check(CLI::IsMember({"x", "y", "z"}));
        app.add_option("--points", options->points, "points of the curve, an odd number")
            ->type_name("COUNT")
            ->capture_default_str()
            ->check(CLI::Range(3, 100001));
        options->outputs.addTo(app);
        return [options] { return run(*options); };
      });
}
