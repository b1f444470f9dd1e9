// export_table: writes stiffness and loss angle of a component over frequency, amplitude and preload.
#include <fmt/format.h>

#include "command/characteristic_table.h"
#include "command_line/command.h"
#include "command_line/component_options.h"
#include "log/new_file.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

struct Options {
  ComponentOptions component;
  std::string output;
  command::TableGrid grid;

  OptionTable table() {
    return {
        component.table(),
        Option("--output", output, "FILE", "CSV to write, one row per combination")
            .required()
            .writes(io::FileKind::characteristics_csv),
        Option("--frequencies", Quantity{&grid.frequencies, "Hz"}, "HZ", "frequencies, such as 1 4 '10 Hz'").required(),
        Option("--amplitudes", Quantity{&grid.amplitudes, "m"}, "METRES", "amplitudes, such as '0.2 mm' '1 mm'")
            .required(),
        Option("--preloads", Quantity{&grid.preloads, "N", element::Range::any()}, "NEWTONS",
               "static forces that the sines swing about, such as 0 '10 kN'")};
  }
};

int run(const Options& options) {
  const io::ComponentDescription description = options.component.read("export_table");
  const auto table = command::makeTable(description.name, description.makeComponent(), options.grid);
  log::writeNewFile(options.output, command::toCsv(table));
  printNotes("export_table", table.notes);
  std::cout << fmt::format("{}: {} rows\n{}\n", table.component, table.rows.size(), options.output);
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"export_table",
       "Writes dynamic stiffness and loss angle of a component over frequency, amplitude and preload, "
       "and tells what such a table cannot say of it.",
       {{"Three frequencies, two amplitudes",
         "--config component.yaml --frequencies 1 4 16 --amplitudes '0.2 mm' '1 mm' --output table.csv"},
        {"Unloaded and under load",
         "--config component.yaml --frequencies 4 --amplitudes '1 mm' --preloads 0 '2 kN' --output table.csv"},
        {"One of several components",
         "--config example.yaml --component left_secondary --frequencies 4 --amplitudes '1 mm' --output left.csv"}}},
      run);
}
