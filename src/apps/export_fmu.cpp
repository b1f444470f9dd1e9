// export_fmu: writes a component as a functional mock-up unit (FMI 2.0 or 3.0, co-simulation).
#include <fmt/format.h>

#include "command_line/command.h"
#include "command_line/component_options.h"
#include "fmi/export.h"
#include "log/new_file.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

struct Options {
  ComponentOptions component;
  std::string output;
  int fmi = 2;

  OptionTable table() {
    return {component.table(), Option("--output", output, "FILE", "FMU to write").required().writes(io::FileKind::fmu),
            Option("--fmi", fmi, "VERSION", "version of the standard, 2 or 3").oneOf({"2", "3"})};
  }
};

int run(const Options& options) {
  const io::ComponentDescription description = options.component.readAny("export_fmu");
  const fmi::Version version = options.fmi == 2 ? fmi::Version::fmi2 : fmi::Version::fmi3;
  const std::string fmu = fmi::toZip(fmi::fmuFiles(description, version, fmi::installedParts()));
  log::writeNewFile(options.output, fmu);
  std::cout << fmt::format("{}: FMI {}.0 for co-simulation, {} bytes\n{}\n", description.name, options.fmi, fmu.size(),
                           options.output);
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"export_fmu",
       "Writes a component as an FMU for co-simulation: displacement in, force out, all parameters settable; of six "
       "directions pose in, wrench out.",
       {{"FMI 2.0", "--config component.yaml --output bush.fmu"},
        {"FMI 3.0", "--config component.yaml --fmi 3 --output bush.fmu"},
        {"One of several components", "--config example.yaml --component left_secondary --output left.fmu"}}},
      run);
}
