// The command `replay` simulates a component on a recorded log, with the same forces as the node to the last bit.
#include "rubber_suspension/gap/replay.h"

#include <fmt/format.h>

#include <algorithm>

#include "command_line/agreement_options.h"
#include "command_line/command.h"
#include "command_line/component_options.h"
#include "command_line/log_options.h"
#include "command_line/plot_option.h"
#include "command_line/warnings.h"
#include "element/refuse.h"
#include "gap/odd_motion.h"
#include "rubber_suspension/gap/pose_replay.h"
#include "rubber_suspension/log/record.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

struct Options {
  ComponentOptions component;
  std::string log;
  std::string output;
  std::string plot;
  bool compare = false;
  bool remove_offset = false;
  AgreementOptions agreement;
  LogOptions log_options;

  OptionTable table() {
    OptionTable options = {
        component.table(),
        Option("--log", log, "FILE", "log to simulate: text (CSV), .mat, HDF5, RPC III or .bag").required().reads(),
        Option("--output", output, "FILE",
               "CSV to write: time_s,displacement_m,force_N; for six directions time_s,x_m ... rz_rad,Fx_N ... Mz_Nm")
            .required()
            .writes(io::file_kind::force_csv),
        Option("--compare", compare,
               "print the agreement with the measured force: RMS error, peak error, energy per cycle, ISO/TS 18571"),
        agreement.table(),
        Option("--remove-offset", remove_offset,
               "subtract the mean difference between measured and simulated force before the printed gap is computed")
            .rare(),
        plotOption(plot, "forces over time and displacement"),
        log_options.table()};
    return options.needs({"--limits", "--json"}, {"--compare"});
  }
};

void noteBridged(const Options& options, std::uint64_t bridged) {
  if (bridged > 0) {
    printNote("replay", fmt::format("{}: {} time gaps were bridged with linear displacement", options.log, bridged));
  }
}

std::vector<gap::ComparedForce> compare(const log::Log& log, const gap::Replay& replay,
                                        const gap::AgreementLimits& limits) {
  return {{"", gap::agreementOf(log, replay.force), limits}};
}

std::vector<gap::ComparedForce> compare(const log::PoseLog& log, const gap::PoseReplay& replay,
                                        const gap::AgreementLimits& limits) {
  std::vector<gap::ComparedForce> compared;
  for (std::size_t k = 0; k < component::kDirections; ++k) {
    log::Log direction;
    direction.name = log.name;
    direction.stamp = log.stamp;
    direction.displacement = log.coordinate[k];
    direction.force = log.wrench[k];
    const auto [least, most] = std::minmax_element(direction.force.begin(), direction.force.end());
    if (least != most && *least < *most) {
      compared.push_back({component::toString(static_cast<component::Direction>(k)),
                          gap::agreementOf(direction, replay.wrench[k]), limits});
      if (compared.back().isMoment()) {
        compared.back().limits.rms = compared.back().limits.peak = std::nullopt;
      }
    }
  }
  element::refuseIf<log::LogError>(compared.empty(), "{}: --compare: the log has no measured force that varies",
                                   log.name);
  return compared;
}

// Writes and prints the agreement. Returns exit status 1 if one of its values exceeds its limit.
int publishAgreement(const Options& options, const std::string& component,
                     const std::vector<gap::ComparedForce>& compared) {
  options.agreement.write(component, options.log, compared);
  int status = kSuccess;
  for (const gap::ComparedForce& one : compared) {
    std::cout << gap::agreementTable(one);
    if (const std::string beyond = gap::beyondLimits(one); !beyond.empty()) {
      printError("replay", options.log + ": " + beyond);
      status = kFailed;
    }
  }
  return status;
}

// Writes the forces or wrenches by means of `write`, and prints a summary.
template <class Log, class Loads, class Replay>
int publish(const Options& options, const std::string& component, const Log& log, const Loads& loads,
            const Replay& replay, void (*write)(const std::string&, const Log&, const Loads&),
            const std::string& summary) {
  const std::vector<gap::ComparedForce> compared =
      options.compare ? compare(log, replay, options.agreement.limits()) : std::vector<gap::ComparedForce>();
  // No file is written before the log has passed all checks.
  during("writing " + options.output, [&] { write(options.output, log, loads); });
  drawPlot(options.plot, [&] { return gap::replayFigure(component, log, loads); });
  std::cout << summary << "\n" << options.output << '\n';
  return publishAgreement(options, component, compared);
}

int runPoses(const Options& options, const io::ComponentDescription& description) {
  const component::SixDirections component = description.six->makeComponent();
  const log::PoseLog log =
      options.log_options.readPoses("replay", options.log, description.name, component.laws().measure);
  const gap::PoseReplay result = gap::replayPoses(component, log);
  if (result.beyond_valid > 0) {
    printWarning("replay", fmt::format("{}: the rotations of {} of {} samples exceed valid_rotation, {:g} rad",
                                       options.log, result.beyond_valid, log.size(), component.laws().valid_rotation));
  }
  noteBridged(options, result.counters.bridged);
  return publish(options, description.name, log, result.wrench, result, &log::writeWrenchCsv,
                 gap::summary(description.name, log, result));
}

int run(const Options& options) {
  options.agreement.limits();  // throws UsageError before any file is read
  options.log_options.requireUse({options.log});
  const io::ComponentDescription description = options.component.readAny("replay");
  if (description.six) {
    element::refuseIf<std::invalid_argument>(
        options.remove_offset,
        "--remove-offset: component '{}' has six directions; accepted: a component of one direction", description.name);
    return runPoses(options, description);
  }
  const log::Log log = options.log_options.read("replay", options.log, description.name);
  if (options.compare || options.remove_offset) {
    log::requireForce(log);
  }
  const gap::Replay result = gap::replay(description.makeComponent(), log);
  warnOfTemperature("replay", options.log, !log.temperature.empty(), description);
  warnOf("replay", options.log, gap::oddMotion(log, result.force, gap::motionScaleOf(description)));
  warnOf("replay", options.log, gap::beyondValid(log, description));
  noteBridged(options, result.bridged);
  return publish(
      options, description.name, log, result.force, result, &log::writeForceCsv,
      gap::summary(description.name, log, result, options.remove_offset ? gap::Offset::removed : gap::Offset::kept));
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"replay",
       "Simulates a component on a recorded log. The forces are identical to those of the node.",
       {{"The force of a log", "--config component.yaml --log log.csv --output force.csv"},
        {"The same with a figure and the agreement with the measured force",
         "--config component.yaml --log log.csv --output force.csv --plot force.svg --compare"},
        {"Columns without names, in mm and kN",
         "--config component.yaml --log raw.csv --columns time displacement force --unit displacement=mm force=kN "
         "--output force.csv"}}},
      run);
}
