// export_table: writes stiffness and loss angle of a component over frequency, amplitude and preload.
#include <fmt/format.h>

#include <memory>

#include "apps/command.h"
#include "apps/component_options.h"
#include "apps/output_options.h"
#include "apps/quantity_option.h"
#include "command/characteristic_table.h"
#include "log/new_file.h"
#include "rubber_suspension/io/component_file.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::apps;

struct Options {
  ComponentOptions component;
  std::string output;
  std::vector<std::string> frequencies;
  std::vector<std::string> amplitudes;
  std::vector<std::string> preloads;
  OutputOptions outputs;
};

std::vector<double> quantities(const std::string& option, const std::vector<std::string>& texts,
                               const std::string& unit, const element::Range& range) {
  std::vector<double> values;
  for (const std::string& text : texts) {
    values.push_back(quantityOf(option, text, unit, range));
  }
  return values;
}

int run(const Options& options) {
  command::TableGrid grid;
  grid.frequencies = quantities("--frequencies", options.frequencies, "Hz", element::Range::positive());
  grid.amplitudes = quantities("--amplitudes", options.amplitudes, "m", element::Range::positive());
  if (!options.preloads.empty()) {
    grid.preloads = quantities("--preloads", options.preloads, "N", element::Range::any());
  }
  options.outputs.check({{"--config", options.component.config}},
                        {{"--output", options.output, io::FileKind::characteristics_csv}});
  const io::ComponentDescription description = options.component.read("export_table");
  const auto table = command::makeTable(description.name, description.makeComponent(), grid);
  log::writeNewFile(options.output, command::toCsv(table));
  for (const std::string& note : table.notes) {
    printNote("export_table", note);
  }
  std::cout << fmt::format("{}: {} rows\n{}\n", table.component, table.rows.size(), options.output);
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand(
      argc, argv, "export_table",
      "Writes dynamic stiffness and loss angle of a component over frequency, amplitude and preload, and tells what "
      "such a table cannot say of it.",
      [](CLI::App& app) -> CommandBody {
        auto options = std::make_shared<Options>();
        options->component.addTo(app);
        app.add_option("--output", options->output, "CSV to write, one row per combination")
            ->required()
            ->type_name("FILE");
        app.add_option("--frequencies", options->frequencies, "frequencies, such as 1 4 '10 Hz'")
            ->required()
            ->type_name("HZ");
        app.add_option("--amplitudes", options->amplitudes, "amplitudes, such as '0.2 mm' '1 mm'")
            ->required()
            ->type_name("METRES");
        app.add_option("--preloads", options->preloads, "static forces that the sines swing about, such as 0 '10 kN'")
            ->type_name("NEWTONS");
        options->outputs.addTo(app);
        return [options] { return run(*options); };
      });
}
