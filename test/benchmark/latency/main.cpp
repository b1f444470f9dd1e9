// The program `benchmark_latency` measures the latency that the node adds to that of an echo node.
#include <fmt/format.h>
#include <ros/init.h>
#include <ros/master.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

#include "benchmark/latency/benchmark_node.h"
#include "benchmark/latency/latency_benchmark.h"
#include "command_line/command.h"
#include "element/refuse.h"
#include "ros_interface/child_process.h"
#include "ros_interface/command_line.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  benchmark::BenchmarkOptions benchmark;
  int echo = 0;
  std::uint64_t soak = 0;

  OptionTable table();
};

int serveEcho(ros_interface::RosCommandLine& line, int components) {
  line.initialise("echo");
  ros::NodeHandle handle;
  const std::vector<ros::Subscriber> answering = benchmark::echo(handle, benchmark::benchmarkNames(components));
  ros::spin();
  return kSuccess;
}

// Starts a master on the loopback interface, so that other programs on this computer do not connect.
std::unique_ptr<ros_interface::ChildProcess> startMaster() {
  const int port = ros_interface::freePort();
  setenv("ROS_HOSTNAME", "127.0.0.1", 1);
  unsetenv("ROS_IP");
  setenv("ROS_MASTER_URI", fmt::format("http://127.0.0.1:{}", port).c_str(), 1);
  return std::make_unique<ros_interface::ChildProcess>(
      std::vector<std::string>{"rosmaster", "--core", "-p", std::to_string(port)});
}

void waitForMaster() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!ros::master::check()) {
    element::refuseIf<std::runtime_error>(std::chrono::steady_clock::now() > end, "the master does not answer");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

void tell(const std::string& what) { std::cerr << "benchmark_latency: " << what << '\n'; }

int measureLatency(const Options& options) {
  const auto rows =
      benchmark::benchmarkLatency(options.benchmark, [](const std::string& what) { tell("measuring " + what); });
  benchmark::printMarkdown(rows, std::cout);
  return kSuccess;
}

int measureSoak(const Options& options) {
  const benchmark::SoakResult result = benchmark::soak(options.soak, options.benchmark.components.front(), tell);
  benchmark::printMarkdown(result, std::cout);
  element::refuseIf<std::runtime_error>(!result.exact(), "not every sample had exactly one force");
  return kSuccess;
}

int measure(ros_interface::RosCommandLine& line, const Options& options) {
  const auto master = startMaster();
  line.initialise("benchmark_latency");
  waitForMaster();
  const ros::NodeHandle keeps_ros_running;
  return options.soak > 0 ? measureSoak(options) : measureLatency(options);
}

OptionTable Options::table() {
  OptionTable options = {
      Option("--components", benchmark.components, "COUNT", "numbers of components, one row each").within(1, 500),
      Option("--sampling-rate", benchmark.rate, "HZ", "samples per second of each component").within(1, 1e5),
      Option("--total-sampling-rate", benchmark.total_rate, "HZ", "samples per second of all components, at most")
          .rare()
          .within(1, 1e6),
      Option("--duration", benchmark.duration, "SECONDS", "length of each run").rare().within(0.1, 3600),
      Option("--pairs", benchmark.pairs, "COUNT", "runs of the echo node, the node and the echo node again, per row")
          .within(1, 1000),
      Option("--diagnose", benchmark.diagnose,
             "compare a node that diagnoses while it runs (~diagnose) with one that does not, both with measured "
             "forces, in the place of node and echo node"),
      Option("--soak", soak, "COUNT",
             "number of samples to send as fast as the node answers, to the first number of --components; reports the "
             "memory of the node instead of the latency")
          .within(1000, 1e11),
      // This program starts itself with this option as the echo node.
      Option("--echo", echo, "COUNT", "be the echo node of this number of components").within(1, 500).hidden()};
  return options.excludes({"--sampling-rate", "--total-sampling-rate", "--duration", "--pairs", "--diagnose"},
                          {"--soak"});
}

int run(ros_interface::RosCommandLine& line, const Options& options) {
  return options.echo > 0 ? serveEcho(line, options.echo) : measure(line, options);
}

}  // namespace

int main(int argc, char** argv) {
  ros_interface::RosCommandLine line(argc, argv);
  return runCommand<Options>(
      line.argc(), line.argv(),
      {"benchmark_latency",
       "Measures round trips through the node `simulate` against those through an empty echo node, in alternating runs "
       "with a master of their own, and prints a Markdown table. Ratios are medians over the pairs of runs, with "
       "quartiles in brackets; those of the echo node to itself show how much the machine alone changes such a ratio.",
       {{"One component", "--components 1 --pairs 11"},
        {"With and without the live diagnosis", "--components 10 --diagnose"},
        {"The node's memory over a million samples", "--soak 1000000"}}},
      [&](Options& options) { return run(line, options); });
}
