// replay: simulates a component on a recorded log, offline, to the last bit as the node does.
#include "rubber_suspension/gap/replay.h"

#include <fmt/format.h>

#include "command_line/command.h"
#include "command_line/component_options.h"
#include "command_line/log_options.h"
#include "command_line/output_options.h"
#include "command_line/warnings.h"
#include "gap/odd_motion.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

struct Options {
  ComponentOptions component;
  std::string log;
  std::string output;
  std::string plot;
  LogOptions log_options;
  OutputOptions outputs;

  OptionTable table() {
    return {component.table(),
            Option("--log", log, "FILE", "log to simulate: text (CSV), .mat, HDF5 or .bag").required(),
            Option("--output", output, "FILE", "CSV to write: time_s,displacement_m,force_N").required(),
            plotOption(plot, "forces over time and displacement"),
            log_options.table(),
            outputs.table()};
  }
};

int run(const Options& options) {
  options.outputs.check(
      {{"--config", options.component.config}, {"--log", options.log}},
      {{"--output", options.output, io::FileKind::force_csv}, {"--plot", options.plot, io::FileKind::figure}});
  options.log_options.requireUse({options.log});
  const io::ComponentDescription description = options.component.read("replay");
  const log::Log log = options.log_options.read("replay", options.log, description.name);
  const gap::Replay result = gap::replay(description.makeComponent(), log);
  warnOfTemperature("replay", options.log, !log.temperature.empty(), description);
  warnOf("replay", options.log, gap::oddMotion(log, result.force, gap::motionScaleOf(description)));
  log::writeForceCsv(options.output, log, result.force);
  if (!options.plot.empty()) {
    io::drawFigure(gap::replayFigure(description.name, log, result.force), options.plot);
  }
  if (result.bridged > 0) {
    printNote("replay",
              fmt::format("{}: {} time gaps bridged, displacement linear in between", options.log, result.bridged));
  }
  std::cout << gap::summary(description.name, log, result) << "\n" << options.output << '\n';
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return runCommand(
      argc, argv, {"replay", "Simulates a component on a recorded log: the same forces as the node, to the last bit."},
      options.table(), [&] { return run(options); });
}
