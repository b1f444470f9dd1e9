// export_bushing: writes a component as a bushing property file of Adams or Altair.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "command/bushing_file.h"
#include "command_line/command.h"
#include "command_line/component_options.h"
#include "element/refuse.h"
#include "log/new_file.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

struct Options {
  ComponentOptions component;
  std::string output;
  std::string axis;
  command::BushingFileOptions bushing;

  OptionTable table() {
    command::BushingCurve& along = bushing.translation;
    command::BushingCurve& about = bushing.rotation;
    return {
        component.table(),
        Option("--output", output, "FILE", "file to write, .bus of Adams or .gbs of Altair")
            .required()
            .writes(io::FileKind::bushing_file),
        Option("--largest-displacement", Quantity{&along.largest, "m"}, "METRES",
               "the curves of forces go as far to both sides, such as '10 mm'"),
        Option("--largest-rotation", Quantity{&about.largest, "rad"}, "RADIANS",
               "the curves of moments go as far to both sides, such as '10 deg'"),
        Option("--frequency", Quantity{&bushing.frequency, "Hz"}, "HZ",
               "frequency of the sine whose loss the damping has")
            .required(),
        Option("--amplitude", Quantity{&along.amplitude, "m"}, "METRES", "amplitude of this sine, such as '1 mm'"),
        Option("--rotation-amplitude", Quantity{&about.amplitude, "rad"}, "RADIANS",
               "amplitude of this sine about an axis, such as '2 deg'")
            .rare(),
        Option("--axis", axis, "AXIS",
               "axis of the bushing that a component of one direction is along: x, y or z (z by itself)")
            .rare()
            .oneOf({"x", "y", "z"}),
        Option("--points", bushing.points, "COUNT", "points of the curves, an odd number").rare().within(3, 100001)};
  }
};

command::BushingFormat formatOf(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  element::refuseIf<UsageError>(ending != ".bus" && ending != ".gbs",
                                "--output: {}; accepted: a file that ends in .bus (Adams) or .gbs (Altair)", path);
  return ending == ".bus" ? command::BushingFormat::adams : command::BushingFormat::altair;
}

// The directions that the curves of the component need, neither fewer nor more.
void requireCurve(const command::BushingCurve& curve, bool needed, const char* largest, const char* amplitude) {
  for (const auto& [value, name] : {std::pair(curve.largest, largest), std::pair(curve.amplitude, amplitude)}) {
    if (needed != (value > 0.0)) {
      throw UsageError(needed ? fmt::format("{} is missing, which the curves of the component need", name)
                              : fmt::format("{} has no effect: the component has no such direction", name));
    }
  }
}

command::Bushing bushingOf(const io::ComponentDescription& description, const std::string& axis) {
  if (!description.six) {
    return command::bushingAlong(*component::directionFromString(axis.empty() ? "z" : axis),
                                 description.makeComponent());
  }
  element::refuseIf<UsageError>(!axis.empty(), "--axis has no effect: the component has directions of its own");
  return command::bushingOf(description.six->makeComponent());
}

int run(Options& options) {
  options.bushing.format = formatOf(options.output);
  element::refuseIf<UsageError>(options.bushing.points % 2 == 0,
                                "--points: {} is even; accepted: an odd number, so that 0 is on the curve",
                                options.bushing.points);
  const io::ComponentDescription description = options.component.readAny("export_bushing");
  const command::Bushing bushing = bushingOf(description, options.axis);
  const auto has = [&](std::size_t first) {
    return std::any_of(&bushing.directions[first], &bushing.directions[first] + 3,
                       [](const auto& direction) { return direction.has_value(); });
  };
  requireCurve(options.bushing.translation, has(component::kX), "--largest-displacement", "--amplitude");
  requireCurve(options.bushing.rotation, has(component::kRx), "--largest-rotation", "--rotation-amplitude");
  const command::BushingFile file = command::makeBushingFile(description.name, bushing, options.bushing);
  log::writeNewFile(options.output, file.text);
  printNotes("export_bushing", file.notes);
  std::cout << options.output << '\n';
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"export_bushing",
       "Writes a component of one direction or of six as a bushing property file of Adams (.bus) or Altair (.gbs): "
       "static curves and constants of damping; tells what the format cannot say of it.",
       {{"Up to 10 mm, with the loss at 4 Hz and 1 mm",
         "--config component.yaml --largest-displacement '10 mm' --frequency 4 --amplitude '1 mm' --output bush.bus"},
        {"Along x, with a finer curve",
         "--config component.yaml --largest-displacement '10 mm' --frequency 4 --amplitude '1 mm' --axis x --points "
         "201 --output bush.bus"},
        {"One of six directions, for Altair",
         "--config hung_body.yaml --component front_left --largest-displacement '5 mm' --largest-rotation '10 deg' "
         "--frequency 10 --amplitude "
         "'0.5 mm' --rotation-amplitude '1 deg' --output bush.gbs"}}},
      run);
}
