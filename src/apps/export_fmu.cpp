// export_fmu: writes a component as a functional mock-up unit (FMI 2.0 or 3.0, co-simulation).
#include <fmt/format.h>

#include <memory>

#include "apps/command.h"
#include "apps/component_options.h"
#include "apps/output_options.h"
#include "fmi/export.h"
#include "log/new_file.h"
#include "rubber_suspension/io/component_file.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::apps;

struct Options {
  ComponentOptions component;
  std::string output;
  int fmi = 2;
  OutputOptions outputs;
};

int run(const Options& options) {
  options.outputs.check({{"--config", options.component.config}}, {{"--output", options.output, io::FileKind::fmu}});
  const io::ComponentDescription description = options.component.read("export_fmu");
  const fmi::Version version = options.fmi == 2 ? fmi::Version::fmi2 : fmi::Version::fmi3;
  const std::string fmu = fmi::makeFmu(description, version, fmi::installedParts());
  log::writeNewFile(options.output, fmu);
  std::cout << fmt::format("{}: FMI {}.0 for co-simulation, {} bytes\n{}\n", description.name, options.fmi, fmu.size(),
                           options.output);
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand(
      argc, argv, "export_fmu",
      "Writes a component as an FMU for co-simulation: displacement in, force out, all parameters settable.",
      [](CLI::App& app) -> CommandBody {
        auto options = std::make_shared<Options>();
        options->component.addTo(app);
        app.add_option("--output", options->output, "FMU to write")->required()->type_name("FILE");
        app.add_option("--fmi", options->fmi, "version of the standard, 2 or 3")
            ->type_name("VERSION")
            ->check(CLI::IsMember({2, 3}))
            ->capture_default_str();
        options->outputs.addTo(app);
        return [options] { return run(*options); };
      });
}
