// The nodes as a benchmark runs them: a process of its own, with components made for the purpose.
#pragma once

#include <string>
#include <vector>

#include "benchmark/latency/round_trip.h"
#include "benchmark/temporary_file.h"
#include "ros_interface/child_process.h"

namespace rubber_suspension::benchmark {

/// A component file with that number of components: by turns five Maxwell elements and Berg's model.
std::string benchmarkComponents(int count);

/// Names of these components, in the order of the file.
std::vector<std::string> benchmarkNames(int count);

/// Answers every displacement at once, as long as the subscribers are held: the floor that the transport sets to any
/// node's latency. Same topics and messages as the node `simulate`, single and bundled, but no component behind them.
std::vector<ros::Subscriber> echo(ros::NodeHandle& handle, const std::vector<std::string>& components);

/// What is run: an echo node, or `simulate` without or with ~diagnose.
enum class NodeKind { echo, plain, diagnosing };

/// A node in a namespace of its own, and what drives it. Needs a master.
class BenchmarkNode {
 public:
  /// Starts the program that lies beside the running one and waits until it serves, with measured forces where they are
  /// `measured`. Throws std::runtime_error.
  BenchmarkNode(NodeKind kind, int components, bool bundled = false, bool measured = false);

  RoundTripMeter& meter() { return meter_; }
  pid_t process() const { return process_.id(); }

 private:
  TemporaryFile file_;
  ros_interface::ChildProcess process_;
  RoundTripMeter meter_;
};

}  // namespace rubber_suspension::benchmark
