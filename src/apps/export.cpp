// The command `export` writes a component for another program: property file, table, constants or FMU.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "command/bushing_file.h"
#include "command/characteristic_table.h"
#include "command/spring_and_dashpot.h"
#include "command_line/command.h"
#include "command_line/component_options.h"
#include "element/refuse.h"
#include "log/new_file.h"
#include "rubber_suspension/element/constants.h"
#ifdef RUBBER_SUSPENSION_FMU
#include "fmi/export.h"
#endif

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

io::FileKind kindOf(const std::string& format) {
  static const std::map<std::string, io::FileKind> kinds = {{"table", io::file_kind::characteristics_csv},
                                                            {"kc", io::file_kind::spring_and_dashpot},
                                                            {"fmu2", io::file_kind::fmu},
                                                            {"fmu3", io::file_kind::fmu}};
  const auto kind = kinds.find(format);
  return kind == kinds.end() ? io::file_kind::bushing_file : kind->second;
}

struct Options {
  ComponentOptions component;
  std::string format;
  std::string output;
  std::string axis;
  command::BushingFileOptions bushing;
  command::TableGrid grid;

  OptionTable table() {
    command::BushingCurve& along = bushing.translation;
    command::BushingCurve& about = bushing.rotation;
    OptionTable options = {
        component.table(),
        Option("--format", format, "FORMAT",
               "format of the file; adams_bus, altair_gbs: bushing property file; table: stiffness and loss angle "
               "(CSV); kc: k and c of a spring and a dashpot; fmu2, fmu3: FMU for co-simulation")
            .required()
            .oneOf({"adams_bus", "altair_gbs", "table", "kc", "fmu2", "fmu3"}),
        Option("--output", output, "FILE", "file to write").required().standsFor([this] {
          return Files{{}, {{"--output", output, kindOf(format)}}};
        }),
        Option("--frequency", Quantity{&bushing.frequency, "Hz"}, "HZ",
               "frequency of the sine that gives the damping; default: nominal_frequency"),
        Option("--amplitude", Quantity{&along.amplitude, "m"}, "METRES",
               "amplitude of the sine that gives the damping, such as '1 mm'; default: nominal_amplitude, or 1 mm"),
        Option("--largest-displacement", Quantity{&along.largest, "m"}, "METRES",
               "largest displacement of the force curves to either side, such as '10 mm' (default: 5 amplitudes)")
            .rare(),
        Option("--rotation-amplitude", Quantity{&about.amplitude, "rad"}, "RADIANS",
               "amplitude of the sine for rotations, such as '2 deg' (default: 1 degree)")
            .rare(),
        Option("--largest-rotation", Quantity{&about.largest, "rad"}, "RADIANS",
               "largest rotation of the moment curves to either side, such as '10 deg' (default: 5 amplitudes)")
            .rare(),
        Option("--axis", axis, "AXIS", "axis of the bushing along which a component of one direction acts (default: z)")
            .rare()
            .oneOf({"x", "y", "z"}),
        Option("--points", bushing.points, "COUNT", "odd number of points of each curve").rare().within(3, 100001),
        Option("--frequencies", Quantity{&grid.frequencies, "Hz"}, "HZ",
               "frequencies of the table, such as 1 4 '10 Hz' (default: 0.1 to 10 times nominal_frequency)")
            .rare(),
        Option("--amplitudes", Quantity{&grid.amplitudes, "m"}, "METRES",
               "amplitudes of the table, such as '0.2 mm' '1 mm' (default: 0.1 to 3 times nominal_amplitude)")
            .rare(),
        Option("--preloads", Quantity{&grid.preloads, "N", element::Range::any()}, "NEWTONS",
               "static preloads of the table, such as 0 '10 kN'; the sines oscillate about them")};
    const std::vector<std::string> property_files = {"--format adams_bus", "--format altair_gbs"};
    options.needs({"--largest-displacement", "--rotation-amplitude", "--largest-rotation", "--axis", "--points"},
                  property_files);
    options.needs({"--frequency", "--amplitude"}, {property_files[0], property_files[1], "--format kc"});
    return options.needs({"--frequencies", "--amplitudes", "--preloads"}, {"--format table"});
  }
};

// Returns a number of the specification or, for six directions, of the first that specifies it; else `otherwise`.
double specified(const io::ComponentDescription& description, const std::string& key, double otherwise) {
  if (!description.six) {
    return description.specification().valueOr(key, otherwise);
  }
  for (const auto& direction : description.six->directions) {
    if (direction && direction->specification().find(key)) {
      return *direction->specification().find(key);
    }
  }
  return otherwise;
}

command::WorkingPoint workingPoint(const Options& options, const io::ComponentDescription& description) {
  const double frequency = options.bushing.frequency;
  const double amplitude = options.bushing.translation.amplitude;
  return {frequency > 0.0 ? frequency : specified(description, "nominal_frequency", 1.0),
          amplitude > 0.0 ? amplitude : specified(description, "nominal_amplitude", 1e-3)};
}

command::Bushing bushingOf(const io::ComponentDescription& description, const std::string& axis) {
  if (!description.six) {
    return command::bushingAlong(*component::directionFromString(axis.empty() ? "z" : axis),
                                 description.makeComponent());
  }
  element::refuseIf<UsageError>(!axis.empty(), "--axis has no effect on a component of six directions");
  return command::bushingOf(description.six->makeComponent());
}

void complete(command::BushingCurve& curve, bool is_there, double amplitude, const char* options) {
  element::refuseIf<UsageError>(!is_there && (curve.largest > 0.0 || curve.amplitude > 0.0),
                                "{} have no effect: the component has no such direction", options);
  curve.amplitude = curve.amplitude > 0.0 ? curve.amplitude : amplitude;
  curve.largest = curve.largest > 0.0 ? curve.largest : 5.0 * curve.amplitude;
}

// The content of a file, and notes on what its format cannot represent.
struct Exported {
  std::string content;
  std::vector<std::string> notes;
};

Exported propertyFile(Options options, const io::ComponentDescription& description) {
  constexpr double kDegree = element::kPi / 180.0;
  command::BushingFileOptions& file = options.bushing;
  element::refuseIf<UsageError>(
      file.points % 2 == 0, "--points: {} is even; accepted: an odd number, so that 0 is on the curve", file.points);
  file.format = options.format == "adams_bus" ? command::BushingFormat::adams : command::BushingFormat::altair;
  const command::Bushing bushing = bushingOf(description, options.axis);
  const auto has = [&](std::size_t first) {
    return std::any_of(&bushing.directions[first], &bushing.directions[first] + 3,
                       [](const auto& direction) { return direction.has_value(); });
  };
  const command::WorkingPoint at = workingPoint(options, description);
  file.frequency = at.frequency;
  complete(file.translation, has(component::kX), at.amplitude, "--amplitude and --largest-displacement");
  complete(file.rotation, has(component::kRx), kDegree, "--rotation-amplitude and --largest-rotation");
  const command::BushingFile made = command::makeBushingFile(description.name, bushing, file);
  return {made.text, made.notes};
}

Exported table(const Options& options, const io::ComponentDescription& description) {
  const command::WorkingPoint at = workingPoint(options, description);
  const component::Component component = description.makeComponent();
  command::TableGrid grid = options.grid;
  const auto about = [](double middle, std::initializer_list<double> factors) {
    std::vector<double> values;
    for (const double factor : factors) {
      values.push_back(factor * middle);
    }
    return values;
  };
  if (grid.frequencies.empty()) {
    grid.frequencies = about(at.frequency, {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0});
  }
  if (grid.amplitudes.empty()) {
    grid.amplitudes = component.linear() ? about(at.amplitude, {1.0}) : about(at.amplitude, {0.1, 0.3, 1.0, 3.0});
  }
  auto made = command::makeTable(description.name, component, grid);
  made.notes.insert(made.notes.begin(), "the component has " + command::stiffnessText(component, at));
  return {command::toCsv(made) + command::asComments(made.notes, "#"), made.notes};
}

Exported springAndDashpot(const Options& options, const io::ComponentDescription& description) {
  const command::WorkingPoint at = workingPoint(options, description);
  const auto values = command::springAndDashpot(description.makeComponent(), at);
  return {command::toYaml(description.name, values, at), values.notes};
}

#ifdef RUBBER_SUSPENSION_FMU
Exported fmu(const Options& options, const io::ComponentDescription& description) {
  const fmi::Version version = options.format == "fmu2" ? fmi::Version::fmi2 : fmi::Version::fmi3;
  const fmi::FmuParts parts = fmi::installedParts();
  Exported made{fmi::toZip(fmi::fmuFiles(description, version, parts)), {}};
  if (parts.windows_binary.empty()) {
    made.notes.emplace_back("the FMU runs on Linux only: this build has no binary for Windows (docs/fmi.md)");
  }
  return made;
}
#else
Exported fmu(const Options& options, const io::ComponentDescription&) {
  throw UsageError("--format " + options.format +
                   ": this build cannot export an FMU; accepted: a build with libzip and TinyXML-2 installed");
}
#endif

Exported exported(const Options& options) {
  const bool of_one = options.format == "table" || options.format == "kc";
  const io::ComponentDescription description =
      of_one ? options.component.read("export") : options.component.readAny("export");
  return options.format == "table"                                ? table(options, description)
         : options.format == "kc"                                 ? springAndDashpot(options, description)
         : kindOf(options.format).name == io::file_kind::fmu.name ? fmu(options, description)
                                                                  : propertyFile(options, description);
}

int run(const Options& options) {
  const Exported made = exported(options);
  log::writeNewFile(options.output, made.content);
  printNotes("export", made.notes);
  std::cout << fmt::format("{}: {} bytes\n", options.output, made.content.size());
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"export",
       "Writes a component in a format of another program. Notes in the file and on the terminal list, with numbers, "
       "what the format cannot represent.",
       {{"A property file of Adams with static curves up to 10 mm and the damping at 4 Hz and 1 mm",
         "--config component.yaml --format adams_bus --largest-displacement '10 mm' --frequency 4 --amplitude '1 mm' "
         "--output bush.bus"},
        {"Stiffness and loss angle over frequency and amplitude, unloaded and under load",
         "--config component.yaml --format table --frequencies 1 4 16 --amplitudes '0.2 mm' '1 mm' --preloads 0 '2 kN' "
         "--output table.csv"},
        {"An FMU for co-simulation", "--config component.yaml --format fmu2 --output bush.fmu"}}},
      run);
}
