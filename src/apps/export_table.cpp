// export_table: writes stiffness and loss angle of a component over frequency, amplitude and preload.
#include <fmt/format.h>

#include "command/characteristic_table.h"
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
  command::TableGrid grid;
  OutputOptions outputs;

  OptionTable table() {
    return {
        component.table(),
        Option("--output", output, "FILE", "CSV to write, one row per combination").required(),
        Option("--frequencies", Quantity{&grid.frequencies, "Hz"}, "HZ", "frequencies, such as 1 4 '10 Hz'").required(),
        Option("--amplitudes", Quantity{&grid.amplitudes, "m"}, "METRES", "amplitudes, such as '0.2 mm' '1 mm'")
            .required(),
        Option("--preloads", Quantity{&grid.preloads, "N", element::Range::any()}, "NEWTONS",
               "static forces that the sines swing about, such as 0 '10 kN'"),
        outputs.table()};
  }
};

int run(const Options& options) {
  options.outputs.check({{"--config", options.component.config}},
                        {{"--output", options.output, io::FileKind::characteristics_csv}});
  const io::ComponentDescription description = options.component.read("export_table");
  const auto table = command::makeTable(description.name, description.makeComponent(), options.grid);
  log::writeNewFile(options.output, command::toCsv(table));
  for (const std::string& note : table.notes) {
    printNote("export_table", note);
  }
  std::cout << fmt::format("{}: {} rows\n{}\n", table.component, table.rows.size(), options.output);
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return runCommand(argc, argv,
                    {"export_table",
                     "Writes dynamic stiffness and loss angle of a component over frequency, amplitude and preload, "
                     "and tells what such a table cannot say of it."},
                    options.table(), [&] { return run(options); });
}
