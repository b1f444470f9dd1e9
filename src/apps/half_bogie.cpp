// The command `half_bogie` simulates a vehicle with component forces from the library or, over topics, from a node.
#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>
#include <optional>

#include "apps/bench_client.h"
#include "apps/topic_exchange.h"
#include "command_line/command.h"
#include "command_line/log_options.h"
#include "command_line/plot_option.h"
#include "io/progress.h"
#include "ros_interface/command_line.h"

using namespace rubber_suspension;
using namespace rubber_suspension::apps;
using namespace rubber_suspension::command_line;
using namespace rubber_suspension::vehicle;

namespace {

struct Options {
  std::string config;
  std::string track;
  std::string vehicle = "struts";
  std::string forces = "library";
  double time_step = 1e-3;
  int delay = 0;
  double speed = VehicleParameters().speed;
  std::string output;
  std::string plot;
  std::string reset;
  LogOptions log_options;

  OptionTable table();
};

std::string percentages(Kind kind, const PerBush<double>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += fmt::format("{}{} {:.4g} %", i == 0 ? "" : ", ", bushNames(kind)[i], 100.0 * values[i]);
  }
  return text;
}

Scene sceneOf(const Options& options) {
  static const std::map<std::string, Kind> kinds = {
      {"struts", Kind::struts}, {"bushes", Kind::bushes}, {"body", Kind::body}};
  Scene scene;
  scene.kind = kinds.at(options.vehicle);
  scene.parameters.speed = options.speed;
  scene.track = Track(options.log_options.read("half_bogie", options.track, ""));
  scene.duration = scene.track.duration();
  scene.step = std::llround(1e9 * options.time_step);
  return scene;
}

// Returns the source of the forces: the library or a running node.
std::unique_ptr<Exchange> partner(ros_interface::RosCommandLine& line, const Options& options, Kind kind,
                                  const Bushes& components) {
  if (options.forces == "library") {
    return std::make_unique<LibraryExchange>(components);
  }
  line.initialise("half_bogie", 0, ros_interface::PoseClient::kPatience);
  noteOpenness("half_bogie");
  if (kind == Kind::struts) {
    return std::make_unique<StrutExchange>(components, options.reset);
  }
  return std::make_unique<PoseExchange>(kind, options.reset);
}

int run(ros_interface::RosCommandLine& line, const Options& options) {
  options.log_options.requireUse({options.track});
  const Scene scene = sceneOf(options);
  const Kind kind = scene.kind;
  const Bushes components = loadBushes(kind, options.config);
  std::optional<io::Activity> simulating("simulating the vehicle");
  const auto start = std::chrono::steady_clock::now();
  const History history = runExchange(scene, *partner(line, options, kind, components), options.delay);
  const History reference = runVariableStep(scene, components, {});
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::string text = fmt::format(
      "{} steps of {:g} ms in {:.3g} s\ndifference of the displacements from a simulation with variable steps and "
      "without delay: {}\n",
      scene.steps(), 1e3 * options.time_step, elapsed.count(),
      percentages(kind, displacementDifference(components, history, reference)));
  if (kind == Kind::struts) {
    const double delay = loopDelay(options.time_step, options.delay);
    const History delayed =
        runVariableStep(scene, loadBushes(kind, options.config, {{"time_delay", {{"delay", {delay}}}}}), {});
    text += fmt::format(
        "difference of the displacements from a simulation with variable steps and a delay of {:g} ms: {}\n",
        1e3 * delay, percentages(kind, displacementDifference(components, history, delayed)));
  }
  simulating.reset();
  std::cout << text;
  if (!options.output.empty()) {
    writeHistoryCsv(options.output, kind, components, history);
  }
  drawPlot(options.plot, [&] {
    return historyFigure(kind, components, history, reference,
                         fmt::format("steps of {:g} ms", 1e3 * options.time_step));
  });
  return kSuccess;
}

OptionTable Options::table() {
  OptionTable options = {
      Option("--config", config, "FILE", "component file of the vehicle (docs/vehicle.md)").required().reads(),
      Option("--vehicle", vehicle, "NAME",
             "struts: half a bogie on components of one direction; bushes: half a bogie on components of six "
             "directions; body: a body on four components of six directions")
          .oneOf({"struts", "bushes", "body"}),
      Option("--track", track, "FILE", "log of the height of the track under the front wheel").required().reads(),
      Option("--forces", forces, "NAME", "source of the forces: the library in this process, or a node over topics")
          .oneOf({"library", "topics"}),
      Option("--time-step", time_step, "SECONDS", "step of the loop").within(1e-6, 0.1),
      Option("--delay", delay, "COUNT", "number of steps after which a force acts; 0: wait for each force")
          .rare()
          .within(0, 100),
      Option("--speed", speed, "M/S", "speed of the vehicle").rare().within(0.1, 1000),
      Option("--output", output, "FILE", "CSV to write: positions, displacements and forces")
          .writes(io::file_kind::vehicle_csv),
      plotOption(plot, "displacements"),
      Option("--reset", reset, "SERVICE", "service of the node to call first, such as simulate/reset").rare(),
      log_options.table()};
  return options.needs({"--reset"}, {"--forces topics"});
}

}  // namespace

int main(int argc, char** argv) {
  ros_interface::RosCommandLine line(argc, argv);
  return runCommand<Options>(
      line.argc(), line.argv(),
      {"half_bogie",
       "Simulates a vehicle on rubber components with Simbody. The forces come from the library or, over topics, from "
       "the node.",
       {{"Half a bogie on a track", "--config half_bogie.yaml --track track.csv --plot vehicle.svg"},
        {"Forces from the node, one step late",
         "--config half_bogie.yaml --track track.csv --forces topics --delay 1 --output vehicle.csv"},
        {"A body on four bushes of six directions",
         "--config hung_body.yaml --vehicle body --track track.csv --output vehicle.csv"}}},
      [&](Options& options) { return run(line, options); });
}
