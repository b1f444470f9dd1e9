// The command `play_log`: plays a log through a running node and records the forces.
#include <fmt/format.h>
#include <ros/init.h>
#include <ros/node_handle.h>
#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <memory>

#include "command.h"
#include "rubber_suspension/ros_interface/bag_log.h"
#include "rubber_suspension/ros_interface/command_line.h"
#include "rubber_suspension/ros_interface/log_player.h"

using namespace rubber_suspension;

namespace {

struct Options {
  PlayOptions play;
  std::string log;
  std::string output;
  std::string bag;
  std::string reset;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--component", options.play.component, "name of the component")->required();
  app.add_option("--log", options.log, "log to play: .csv, .mat, or .bag with the node's topics")->required();
  app.add_option("--output", options.output, "CSV file for the forces: time_s,displacement_m,force_N");
  app.add_option("--bag", options.bag, "bag for displacements, measured forces and forces");
  app.add_option("--rate", options.play.rate, "multiple of the log's own speed; 0: as fast as the node answers")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--in-flight", options.play.in_flight, "samples sent and not yet answered, at most")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}))
      ->capture_default_str();
  app.add_option("--timeout", options.play.answer_timeout, "time to wait for an answer [s]")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  app.add_option("--connect-timeout", options.play.connect_timeout, "time to wait for the node [s]")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  app.add_option("--reset", options.reset,
                 "service that makes the specimen new before the first sample, such as "
                 "/simulate/reset");
}

void reset(ros::NodeHandle& handle, const std::string& service) {
  std_srvs::Trigger trigger;
  if (!ros::service::call(handle.resolveName(service), trigger) || !trigger.response.success) {
    throw PlayError(fmt::format("service {} failed {}", service, trigger.response.message));
  }
}

void writeBag(const Options& options, const Log& log, const PlayResult& result) {
  const std::int64_t shift = headerShift(log);
  BagWriter writer(options.bag, options.play.component);
  for (std::size_t i = 0; i < log.size(); ++i) {
    writer.writeDisplacement(log.stamp[i] + shift, log.displacement[i]);
    if (!log.force.empty()) {
      writer.writeMeasuredForce(log.stamp[i] + shift, log.force[i]);
    }
    if (result.answers[i] > 0) {
      writer.writeForce(log.stamp[i] + shift, log.displacement[i], result.force[i]);
    }
  }
  writer.close();
}

void writeCsv(const Options& options, const Log& log, const PlayResult& result) {
  std::vector<double> force;
  force.reserve(log.size());
  for (const ComponentForce& answer : result.force) {
    force.push_back(answer.total);
  }
  writeForceCsv(options.output, log, force);
}

int report(const Options& options, const Log& log, const PlayResult& result) {
  const std::string counts =
      fmt::format("{}: {} samples, {} answered, {} forces of other stamps; {:.3g} s, {:.0f} samples per second",
                  options.play.component, log.size(), result.answered(), result.unexpected, result.duration,
                  static_cast<double>(result.answered()) / std::max(result.duration, 1e-9));
  if (!result.exactlyOneEach()) {
    throw PlayError(counts + "; not every sample had exactly one force");
  }
  std::cout << counts << "; every sample had exactly one force\n";
  return kSuccess;
}

int play(RosCommandLine& line, const Options& options) {
  const Log log = readAnyLog(options.log, options.play.component);
  for (const std::string& note : log.notes) {
    std::cerr << "play_log: note: " << note << '\n';
  }
  line.initialise("play_log");
  ros::NodeHandle handle;
  LogPlayer player(handle, options.play);
  player.connect();
  if (!options.reset.empty()) {
    reset(handle, options.reset);
  }
  const PlayResult result = player.play(log);
  if (!options.bag.empty()) {
    writeBag(options, log, result);
  }
  if (!options.output.empty() && result.answered() == log.size()) {
    writeCsv(options, log, result);
  }
  return report(options, log, result);
}

}  // namespace

int main(int argc, char** argv) {
  RosCommandLine line(argc, argv);
  return runCommand(line.argc(), line.argv(), "play_log",
                    "Play a log through a running node and record the forces. The node answers on "
                    "<component>/force; see launch/replay.launch.",
                    [&](CLI::App& app) {
                      const auto options = std::make_shared<Options>();
                      addOptions(app, *options);
                      return [&line, options] { return play(line, *options); };
                    });
}
