// The test node `check_force` plays a log through a node and passes if the node's forces agree with a reference.
#include <fmt/format.h>
#include <ros/node_handle.h>

#include "apps/bench_client.h"
#include "command_line/agreement_options.h"
#include "command_line/command.h"
#include "command_line/log_options.h"
#include "command_line/plot_option.h"
#include "ros_interface/command_line.h"
#include "ros_interface/force_check.h"
#include "rubber_suspension/io/component_file.h"

using namespace rubber_suspension;
using namespace rubber_suspension::apps;
using namespace rubber_suspension::command_line;

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
  AgreementOptions agreement;
  bool text = false;

  OptionTable table();
};

std::string reportPath(const Options& options) {
  return asUsage("", [&] { return options.report.empty() ? "" : ros_interface::testReportPath(options.report); });
}

OptionTable Options::table() {
  OptionTable options = {
      Option("--component", play.component, "NAME",
             "name of the component: its topics are NAME/displacement and NAME/force, below the node's namespace")
          .required(),
      Option("--log", log, "FILE", "log to play: text (CSV), .mat, HDF5, RPC III or .bag").required().reads(),
      Option("--tolerance", tolerance, "RATIO",
             "largest gap with which the test passes; RMS of the force difference over the standard deviation of the "
             "reference")
          .required()
          .within(0, 1e9),
      Option("--config", config, "FILE",
             "component file whose simulated force is the reference (default: the force measured in the log)")
          .reads(),
      Option("--config-component", config_component, "NAME",
             "name of the component in the file of --config, if it differs from --component")
          .rare(),
      Option("--skip", skip, "SECONDS", "time at the start of the log that is played but not compared")
          .rare()
          .within(0, 1e9),
      agreement.table(),
      playerTable(play, "bench"),
      Option("--reset", reset, "SERVICE", "service (std_srvs/Trigger) to call before the first sample").rare(),
      plotOption(plot, "forces, and their difference, over time and displacement").rare(),
      Option("--gtest_output", report, "xml:FILE", "report to write; set by rostest").rare().standsFor([this] {
        return Files{{}, {{"--gtest_output", reportPath(*this), io::file_kind::test_report}}};
      }),
      Option("--text", text, "accepted because rostest --text passes it; without effect").rare(),
      log_options.table()};
  return options.needs({"--config-component"}, {"--config"});
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
  std::vector<gap::ComparedForce> compared;  ///< empty if no force was compared
  io::Figure figure;                         ///< without axes if no force was compared
};

Outcome check(ros_interface::RosCommandLine& line, const Options& options) {
  const log::Log log = options.log_options.read("check_force", options.log, options.play.component);
  const ros_interface::ForceReference reference = referenceFor(options, log);
  line.initialise("check_force", 0, options.play.connect_timeout);
  ros::NodeHandle handle;
  noteOpenness("check_force");
  ros_interface::LogPlayer player(handle, withNotes(options.play, "check_force"));
  player.connect();
  resetComponent(handle, options.reset);
  const ros_interface::PlayResult result = player.play(log);
  const std::string& component = options.play.component;
  const auto agreement = ros_interface::compareForces(log, reference, result, options.skip);
  Outcome outcome;
  outcome.cases = {ros_interface::checkAnswers(component, log, result),
                   ros_interface::checkForces(log, reference, result, agreement, options.tolerance)};
  if (agreement) {
    outcome.compared = {{"", *agreement, options.agreement.limits()}};
    if (const std::string beyond = gap::beyondLimits(outcome.compared.front()); !beyond.empty()) {
      outcome.cases.push_back({"agreement", false, beyond, 0.0});
    }
    outcome.figure = ros_interface::forceFigure(component, log, reference, result);
  }
  return outcome;
}

// An exception during the check is reported as a failed check, unless the command line is wrong.
Outcome checkOrFail(ros_interface::RosCommandLine& line, const Options& options) {
  try {
    return check(line, options);
  } catch (const UsageError&) {
    throw;
  } catch (const std::exception& error) {
    return {{{"forces", false, error.what(), 0.0}}, {}, {}};
  }
}

int run(ros_interface::RosCommandLine& line, const Options& options) {
  const std::string path = reportPath(options);
  options.agreement.limits();  // throws UsageError before the log is played
  options.log_options.requireUse({options.log});
  const Outcome outcome = checkOrFail(line, options);
  if (!path.empty()) {
    ros_interface::writeTestReport(path, "check_force", outcome.cases);
  }
  if (!outcome.figure.axes.empty()) {
    drawPlot(options.plot, [&] { return outcome.figure; });
  }
  options.agreement.write(options.play.component, options.log, outcome.compared);
  for (const gap::ComparedForce& compared : outcome.compared) {
    std::cout << gap::agreementTable(compared);
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
  return runCommand<Options>(
      line.argc(), line.argv(),
      {"check_force",
       "Plays a log through a bench and passes if its forces agree with the forces measured in the log or simulated "
       "from a component file; a test node for rostest.",
       {{"Against the force in the log", "--component bush --log log.csv --tolerance 0.05"},
        {"Against a component file, to the last bit",
         "--component bush --log log.csv --config component.yaml --tolerance 0"},
        {"Also with a limit of the total of ISO/TS 18571, without the first two seconds",
         "--component bush --log log.csv --tolerance 0.2 --limits iso18571=0.8 --json agreement.json --skip 2"}}},
      [&](Options& options) { return run(line, options); });
}
