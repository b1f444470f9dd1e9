// The command `half_bogie`: a vehicle on rubber components, stepped with their forces from the library or over topics.
#include <fmt/format.h>

#include <chrono>

#include "apps/bench_client.h"
#include "apps/topic_exchange.h"
#include "command_line/command.h"
#include "command_line/log_options.h"
#include "command_line/output_options.h"
#include "ros_interface/command_line.h"
#include "vehicle/components.h"
#include "vehicle/simulation.h"
#include "vehicle/stability.h"

using namespace rubber_suspension;
using namespace rubber_suspension::apps;
using namespace rubber_suspension::command_line;
using namespace rubber_suspension::vehicle;

namespace {

struct Options {
  std::string config;
  std::string track;
  std::string forces = "library";
  double time_step = 1e-3;
  int delay = 0;
  double speed = VehicleParameters().speed;
  std::string output;
  std::string plot;
  std::string reset;
  bool stability = false;
  LogOptions log_options;
  OutputOptions outputs;

  OptionTable table();
};

std::string percentages(const PerStrut& values) {
  std::string text;
  for (std::size_t i = 0; i < kStruts; ++i) {
    text += fmt::format("{}{} {:.4g} %", i == 0 ? "" : ", ", strutNames()[i], 100.0 * values[i]);
  }
  return text;
}

History runLoop(ros_interface::RosCommandLine& line, const Options& options, const Scene& scene,
                const std::vector<component::Component>& components) {
  if (options.forces == "implicit") {
    return runImplicit(scene, components);
  }
  if (options.forces == "topics") {
    line.initialise("half_bogie");
    const ros::NodeHandle handle;
    noteOpenness("half_bogie");
    TopicExchange exchange(handle, options.reset);
    return runExchange(scene, exchange, options.delay);
  }
  LibraryExchange exchange(components);
  return runExchange(scene, exchange, options.delay);
}

int runTrack(ros_interface::RosCommandLine& line, const Options& options) {
  const std::vector<component::Component> components = loadStruts(options.config);
  Scene scene;
  scene.parameters.speed = options.speed;
  const log::Log track = options.log_options.read("half_bogie", options.track, "");
  scene.track = Track(track);
  scene.duration = scene.track.duration();
  scene.step = std::llround(1e9 * options.time_step);
  const auto start = std::chrono::steady_clock::now();
  const History history = runLoop(line, options, scene, components);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const History reference = runVariableStep(scene, components, {});
  std::cout << fmt::format("{} steps of {:g} ms in {:.3g} s\n", scene.steps(), 1e3 * options.time_step,
                           elapsed.count());
  std::cout << "displacements against variable steps without delay: "
            << percentages(displacementDifference(history, reference)) << '\n';
  if (options.forces != "implicit") {
    const double delay = loopDelay(options.time_step, options.delay);
    const History delayed =
        runVariableStep(scene, loadStruts(options.config, {{"time_delay", {{"delay", {delay}}}}}), {});
    std::cout << fmt::format("displacements against the same with a delay of {:g} ms: {}\n", 1e3 * delay,
                             percentages(displacementDifference(history, delayed)));
  }
  if (!options.output.empty()) {
    writeHistoryCsv(options.output, history);
  }
  if (!options.plot.empty()) {
    io::drawFigure(historyFigure(history, reference, fmt::format("loop at {:g} ms", 1e3 * options.time_step)),
                   options.plot);
  }
  return kSuccess;
}

// Growth over the step around the limit of each delay.
io::Figure stabilityFigure(const VehicleParameters& parameters, const std::vector<component::Component>& components,
                           double margin) {
  io::Axes axes;
  axes.x_label = "step [ms]";
  axes.y_label = "growth of the oscillation [1/s]";
  double longest = 0.0;
  for (int delay = 0; delay <= 2; ++delay) {
    const double limit = margin / (delay + 0.5);
    io::Curve curve{fmt::format("measured, --delay {}", delay), {}, {}, "o-", delay};
    for (double share = 0.2; share < 1.35; share += 0.1) {
      const double step = share * limit;
      curve.x.push_back(1e3 * step);
      curve.y.push_back(growthRate(parameters, components, std::llround(1e9 * step), delay));
    }
    longest = std::max(longest, curve.x.back());
    axes.curves.push_back(curve);
    axes.curves.push_back({delay == 0 ? "limit by the delay margin" : "", {1e3 * limit}, {0.0}, "x", delay});
  }
  axes.curves.push_back({"", {0.0, longest}, {0.0, 0.0}, ":", 7});
  return {"Stability of the loop", {axes}, 1};
}

int runStability(const Options& options) {
  const std::vector<component::Component> components = loadStruts(options.config);
  VehicleParameters parameters;
  parameters.speed = options.speed;
  const DelayMargin margin = delayMargin(parameters, components);
  std::cout << fmt::format("delay margin {:.4g} ms, at {:.4g} Hz\n\n", 1e3 * margin.delay, margin.frequency);
  std::cout
      << "| answer used | mean delay | largest step by the delay margin [ms] | measured [ms] |\n|---|---|---|---|\n";
  for (int delay = 0; delay <= 2; ++delay) {
    const double theory = margin.delay / (delay + 0.5);
    std::cout << fmt::format(
        "| {} | {:.1f} steps | {:.3g} | {:.3g} |\n",
        delay == 0 ? "of the same step" : fmt::format("of {} step{} before", delay, delay > 1 ? "s" : ""), delay + 0.5,
        1e3 * theory, 1e3 * largestStableStep(parameters, components, delay, theory));
  }
  if (!options.plot.empty()) {
    io::drawFigure(stabilityFigure(parameters, components, margin.delay), options.plot);
  }
  return kSuccess;
}

int run(ros_interface::RosCommandLine& line, const Options& options) {
  if (!options.stability) {
    options.log_options.requireUse({options.track});
  }
  options.outputs.check(
      {{"--config", options.config}, {"--track", options.track}},
      {{"--output", options.output, io::FileKind::vehicle_csv}, {"--plot", options.plot, io::FileKind::figure}});
  return options.stability ? runStability(options) : runTrack(line, options);
}

// Each way to run takes some of the options; none is passed over.
OptionTable Options::table() {
  OptionTable options = {
      Option("--config", config, "FILE", "component file with front_primary, rear_primary and secondary").required(),
      Option("--track", track, "FILE", "log whose displacement is the height of the track under the front wheel"),
      Option("--forces", forces, "NAME",
             "where the forces come from: library and topics at fixed steps, implicit with iterations")
          .oneOf({"library", "topics", "implicit"}),
      Option("--time-step", time_step, "SECONDS", "step of the loop").within(1e-6, 0.1),
      Option("--delay", delay, "COUNT", "steps that pass before a force acts; 0 waits for each answer").within(0, 100),
      Option("--speed", speed, "M/S", "speed of the vehicle").within(0.1, 1000),
      Option("--output", output, "FILE", "CSV to write: positions, displacements and forces"),
      plotOption(plot, "displacements over time, or of growth over the step,"),
      Option("--reset", reset, "SERVICE", "service of the node to call first, as simulate/reset"),
      Option("--stability", stability, "print the largest stable step of a loop instead of running"),
      log_options.table(),
      outputs.table()};
  options.oneOf({"--track", "--stability"});
  options.excludes({"--forces", "--time-step", "--delay", "--output", "--reset"}, {"--stability"});
  options.excludes(LogOptions::names(), {"--stability"});
  return options.needs({"--reset"}, {"--forces topics"}).excludes({"--delay"}, {"--forces implicit"});
}

}  // namespace

int main(int argc, char** argv) {
  ros_interface::RosCommandLine line(argc, argv);
  Options options;
  return runCommand(line.argc(), line.argv(),
                    {"half_bogie",
                     "Simulates a vehicle on rubber components with Simbody, their forces from the library or, over "
                     "topics, from the node."},
                    options.table(), [&] { return run(line, options); });
}
