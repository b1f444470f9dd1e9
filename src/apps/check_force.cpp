// The test node `check_force`: plays a log through a bench and passes if its forces agree with a reference.
#include <fmt/format.h>
#include <ros/node_handle.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "apps/bench_client.h"
#include "apps/command.h"
#include "apps/log_options.h"
#include "apps/output_options.h"
#include "apps/plot_option.h"
#include "ros_interface/command_line.h"
#include "ros_interface/force_check.h"
#include "rubber_suspension/io/component_file.h"

using namespace rubber_suspension;
using namespace rubber_suspension::apps;

namespace {

struct Options {
  ros_interface::PlayOptions play;
  std::string log;
  LogOptions log_options;
  std::string config;
  std::string config_component;
  double tolerance = 0.0;
  double skip = 0.0;
  std::string reset;
  std::string report;
  std::string plot;
  bool text = false;
  OutputOptions outputs;
};

// Refuses what is not a number, which a range lets pass.
std::string notNegative(const std::string& text) {
  const double value = std::strtod(text.c_str(), nullptr);
  return value >= 0.0 && std::isfinite(value) ? "" : "'" + text + "'; accepted: a number of 0 or more";
}

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--component", options.play.component,
                 "name of the component: its topics are NAME/displacement and "
                 "NAME/force, below the node's namespace")
      ->required()
      ->type_name("NAME");
  app.add_option("--log", options.log, "log to play: text (CSV), .mat, HDF5 or .bag")->required()->type_name("FILE");
  app.add_option("--tolerance", options.tolerance,
                 "largest gap that passes: RMS of the difference over the standard deviation of the reference")
      ->required()
      ->check(notNegative)
      ->type_name("RATIO");
  app.add_option(
         "--config", options.config,
         "component file whose force for this log is the reference; if absent, it is the force measured in the log")
      ->type_name("FILE");
  app.add_option("--config-component", options.config_component, "its name in that file, if different")
      ->type_name("NAME");
  app.add_option("--skip", options.skip, "start of the log that is played but not compared")
      ->check(CLI::Range(0.0, 1e9))
      ->type_name("SECONDS");
  app.add_option("--playback-speed", options.play.rate,
                 "multiple of the log's own speed; 0: as fast as the bench answers")
      ->type_name("FACTOR")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--in-flight", options.play.in_flight, "samples sent and not yet answered, at most")
      ->type_name("COUNT")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}))
      ->capture_default_str();
  app.add_option("--timeout", options.play.answer_timeout, "time to wait for an answer")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  app.add_option("--connect-timeout", options.play.connect_timeout, "time to wait for the bench")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  app.add_option("--reset", options.reset, "service (std_srvs/Trigger) to call before the first sample")
      ->type_name("SERVICE");
  addPlotOption(app, options.plot, "forces over time and displacement, and of their difference,");
  app.add_option("--gtest_output", options.report, "report to write; set by rostest")->type_name("xml:FILE");
  app.add_flag("--text", options.text, "accepted without effect; set by rostest --text");
}

ros_interface::ForceReference referenceFor(const Options& options, const log::Log& log) {
  if (options.config.empty()) {
    return ros_interface::measuredReference(log);
  }
  const std::string& name = options.config_component.empty() ? options.play.component : options.config_component;
  const auto components = io::loadComponentFile(options.config);
  return ros_interface::simulatedReference(io::selectComponent(components, name, options.config).makeComponent(), log,
                                           options.config);
}

struct Outcome {
  std::vector<ros_interface::TestCase> cases;
  io::Figure figure;  ///< without axes where there was nothing to compare
};

Outcome check(ros_interface::RosCommandLine& line, const Options& options) {
  const log::Log log = options.log_options.read("check_force", options.log, options.play.component);
  const ros_interface::ForceReference reference = referenceFor(options, log);
  line.initialise("check_force", 0, options.play.connect_timeout);
  ros::NodeHandle handle;
  noteOpenness("check_force");
  ros_interface::LogPlayer player(handle, options.play);
  player.connect();
  resetComponent(handle, options.reset);
  const ros_interface::PlayResult result = player.play(log);
  const std::string& component = options.play.component;
  return {
      {ros_interface::checkAnswers(component, log, result),
       ros_interface::checkForces(log, reference, result, options.tolerance, options.skip)},
      result.answered() < log.size() ? io::Figure() : ros_interface::forceFigure(component, log, reference, result)};
}

// Whatever keeps the check from being made is a failure of it, and belongs into the report.
Outcome checkOrFail(ros_interface::RosCommandLine& line, const Options& options) {
  try {
    return check(line, options);
  } catch (const UsageError&) {
    throw;
  } catch (const std::exception& error) {
    return {{{"forces", false, error.what(), 0.0}}, {}};
  }
}

std::string reportPath(const Options& options) {
  try {
    return options.report.empty() ? "" : ros_interface::testReportPath(options.report);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

int run(ros_interface::RosCommandLine& line, const Options& options) {
  const std::string path = reportPath(options);
  options.outputs.check(
      {{"--log", options.log}, {"--config", options.config}},
      {{"--gtest_output", path, io::FileKind::test_report}, {"--plot", options.plot, io::FileKind::figure}});
  options.log_options.requireUse({options.log});
  const Outcome outcome = checkOrFail(line, options);
  if (!path.empty()) {
    ros_interface::writeTestReport(path, "check_force", outcome.cases);
  }
  if (!options.plot.empty() && !outcome.figure.axes.empty()) {
    io::drawFigure(outcome.figure, options.plot);
  }
  int status = kSuccess;
  for (const ros_interface::TestCase& test : outcome.cases) {
    if (test.passed) {
      std::cout << fmt::format("{}: passed: {}\n", test.name, test.message);
    } else {
      printError("check_force", test.message);
      status = kFailed;
    }
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  ros_interface::RosCommandLine line(argc, argv);
  return runCommand(
      line.argc(), line.argv(), "check_force",
      "Plays a log through a bench and passes if its forces agree with the force measured in the log, or with "
      "that of a component file; a test node for rostest.",
      [&](CLI::App& app) -> CommandBody {
        const auto options = std::make_shared<Options>();
        addOptions(app, *options);
        options->log_options.addTo(app);
        options->outputs.addTo(app);
        return [&line, &app, options] {
          if (options->config.empty()) {
            refuseUnused(app, {"--config-component"}, "without --config");
          }
          return run(line, *options);
        };
      });
}
