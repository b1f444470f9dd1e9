// The command `half_bogie`: a vehicle on rubber components, stepped with their forces from the library or over topics.
#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "apps/bench_client.h"
#include "apps/topic_exchange.h"
#include "command_line/command.h"
#include "command_line/log_options.h"
#include "command_line/plot_option.h"
#include "element/refuse.h"
#include "io/progress.h"
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
  std::string vehicle = "struts";
  std::string forces = "library";
  double time_step = 1e-3;
  int delay = 0;
  double speed = VehicleParameters().speed;
  std::string output;
  std::string plot;
  std::string reset;
  bool stability = false;
  LogOptions log_options;

  OptionTable table();
};

template <class Names, class Values>
std::string percentages(const Names& names, const Values& values) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += fmt::format("{}{} {:.4g} %", i == 0 ? "" : ", ", names[i], 100.0 * values[i]);
  }
  return text;
}

Scene sceneOf(const Options& options) {
  Scene scene;
  scene.parameters.speed = options.speed;
  scene.track = Track(options.log_options.read("half_bogie", options.track, ""));
  scene.duration = scene.track.duration();
  scene.step = std::llround(1e9 * options.time_step);
  return scene;
}

std::string summary(const Scene& scene, std::chrono::steady_clock::time_point start, const std::string& differences) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return fmt::format("{} steps of {:g} ms in {:.3g} s\ndisplacements against variable steps without delay: {}\n",
                     scene.steps(), 1e-6 * static_cast<double>(scene.step), elapsed.count(), differences);
}

// A loop with a partner: the node, or the library by components that are loaded here.
template <class Topics, class Library, class Components, class Run>
auto runLoop(ros_interface::RosCommandLine& line, const Options& options, const std::vector<std::string>& names,
             const Components& components, Run loop) {
  if (options.forces == "topics") {
    line.initialise("half_bogie", 0, ros_interface::PoseClient::kPatience);
    const ros::NodeHandle handle;
    noteOpenness("half_bogie");
    Topics exchange(handle, names, options.reset);
    return loop(exchange);
  }
  Library exchange(components);
  return loop(exchange);
}

// A vehicle on components of six directions.
int runBushed(ros_interface::RosCommandLine& line, const Options& options, BushedKind kind) {
  const PerBush<component::SixDirections> components = loadBushes(kind, options.config);
  const Scene scene = sceneOf(options);
  std::optional<io::Activity> simulating("simulating the vehicle");
  const auto start = std::chrono::steady_clock::now();
  const BushedHistory history = runLoop<TopicWrenchExchange, LibraryWrenchExchange>(
      line, options, bushNames(kind), components,
      [&](WrenchExchange& exchange) { return runExchange(scene, kind, exchange, options.delay); });
  const BushedHistory reference = runVariableStep(scene, kind, components, {});
  simulating.reset();
  std::cout << summary(scene, start,
                       percentages(bushNames(kind), displacementDifference(components, history, reference)));
  if (!options.output.empty()) {
    writeHistoryCsv(options.output, bushNames(kind), components, history);
  }
  return kSuccess;
}

int runTrack(ros_interface::RosCommandLine& line, const Options& options) {
  const std::vector<component::Component> components = loadStruts(options.config);
  const Scene scene = sceneOf(options);
  std::optional<io::Activity> simulating("simulating the vehicle");
  const auto start = std::chrono::steady_clock::now();
  const History history =
      options.forces == "implicit"
          ? runImplicit(scene, components)
          : runLoop<TopicExchange, LibraryExchange>(
                line, options, {strutNames().begin(), strutNames().end()}, components,
                [&](ForceExchange& exchange) { return runExchange(scene, exchange, options.delay); });
  const History reference = runVariableStep(scene, components, {});
  std::string text = summary(scene, start, percentages(strutNames(), displacementDifference(history, reference)));
  if (options.forces != "implicit") {
    const double delay = loopDelay(options.time_step, options.delay);
    const History delayed =
        runVariableStep(scene, loadStruts(options.config, {{"time_delay", {{"delay", {delay}}}}}), {});
    text += fmt::format("displacements against the same with a delay of {:g} ms: {}\n", 1e3 * delay,
                        percentages(strutNames(), displacementDifference(history, delayed)));
  }
  simulating.reset();
  std::cout << text;
  if (!options.output.empty()) {
    writeHistoryCsv(options.output, history);
  }
  drawPlot(options.plot,
           [&] { return historyFigure(history, reference, fmt::format("loop at {:g} ms", 1e3 * options.time_step)); });
  return kSuccess;
}

// Growth over the step around the limit of each delay.
io::Figure stabilityFigure(const VehicleParameters& parameters, const std::vector<component::Component>& components,
                           double margin) {
  io::Axes axes{"", "step [ms]", "growth of the oscillation [1/s]"};
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
  std::optional<io::Activity> searching("finding the largest stable step");
  const DelayMargin margin = delayMargin(parameters, components);
  std::string text = fmt::format(
      "delay margin {:.4g} ms, at {:.4g} Hz\n\n"
      "| answer used | mean delay | largest step by the delay margin [ms] | measured [ms] |\n|---|---|---|---|\n",
      1e3 * margin.delay, margin.frequency);
  for (int delay = 0; delay <= 2; ++delay) {
    const double theory = margin.delay / (delay + 0.5);
    text +=
        fmt::format("| {} | {:.1f} steps | {:.3g} | {:.3g} |\n",
                    delay == 0 ? "of the same step" : fmt::format("of {} step{} before", delay, delay > 1 ? "s" : ""),
                    delay + 0.5, 1e3 * theory, 1e3 * largestStableStep(parameters, components, delay, theory));
  }
  searching.reset();
  std::cout << text;
  drawPlot(options.plot, [&] { return stabilityFigure(parameters, components, margin.delay); });
  return kSuccess;
}

int run(ros_interface::RosCommandLine& line, const Options& options) {
  if (!options.stability) {
    options.log_options.requireUse({options.track});
  }
  if (options.vehicle == "struts") {
    return options.stability ? runStability(options) : runTrack(line, options);
  }
  element::refuseIf<UsageError>(
      options.forces == "implicit",
      "--forces implicit: of components of six directions only with --forces library or topics");
  return runBushed(line, options, options.vehicle == "body" ? BushedKind::body : BushedKind::half_bogie);
}

// Each way to run takes some of the options; none is passed over.
OptionTable Options::table() {
  OptionTable options = {
      Option("--config", config, "FILE", "component file of the vehicle (docs/vehicle.md)").required().reads(),
      Option("--vehicle", vehicle, "NAME",
             "struts: half a bogie on components of one direction; bushes: the same on components of six; body: a body "
             "on four bushes of six directions")
          .oneOf({"struts", "bushes", "body"}),
      Option("--track", track, "FILE", "log of the height of the track under the front wheel").reads(),
      Option("--forces", forces, "NAME",
             "where the forces come from: library and topics at fixed steps, implicit with iterations")
          .oneOf({"library", "topics", "implicit"}),
      Option("--time-step", time_step, "SECONDS", "step of the loop").within(1e-6, 0.1),
      Option("--delay", delay, "COUNT", "steps that pass before a force acts; 0 waits for each answer")
          .rare()
          .within(0, 100),
      Option("--speed", speed, "M/S", "speed of the vehicle").rare().within(0.1, 1000),
      Option("--output", output, "FILE", "CSV to write: positions, displacements and forces")
          .writes(io::FileKind::vehicle_csv),
      plotOption(plot, "displacements, or growth over the step,"),
      Option("--reset", reset, "SERVICE", "service of the node to call first, as simulate/reset").rare(),
      Option("--stability", stability, "print the largest stable step of a loop instead of running"),
      log_options.table()};
  options.oneOf({"--track", "--stability"});
  options.excludes({"--forces", "--time-step", "--delay", "--output", "--reset"}, {"--stability"});
  options.excludes(LogOptions::names(), {"--stability"});
  options.excludes({"--plot", "--stability"}, {"--vehicle bushes"})
      .excludes({"--plot", "--stability"}, {"--vehicle body"});
  return options.needs({"--reset"}, {"--forces topics"}).excludes({"--delay"}, {"--forces implicit"});
}

}  // namespace

int main(int argc, char** argv) {
  ros_interface::RosCommandLine line(argc, argv);
  return runCommand<Options>(
      line.argc(), line.argv(),
      {"half_bogie",
       "Simulates a vehicle on rubber components with Simbody, their forces from the library or, over "
       "topics, from the node.",
       {{"The largest stable step", "--config half_bogie.yaml --stability"},
        {"With forces from the node, a step late",
         "--config half_bogie.yaml --track track.csv --forces topics --delay 1 --output vehicle.csv"},
        {"A body on four bushes of six directions",
         "--config hung_body.yaml --vehicle body --track track.csv --output vehicle.csv"}}},
      [&](Options& options) { return run(line, options); });
}
