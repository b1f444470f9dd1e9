// The nodes that a benchmark measures, each in a process of its own with generated components. Also measures the round
// trips from a displacement to its force, at a rate or as fast as possible.
#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "numerics/quantile.h"
#include "ros_interface/child_process.h"
#include "ros_interface/serving_thread.h"
#include "support/scratch_folder.h"

namespace rubber_suspension::benchmark {

/// Returns a component file with `count` components. They have five Maxwell elements or Berg's model, by turns.
std::string benchmarkComponents(int count);

/// Returns the names of the generated components in the order of the file.
std::vector<std::string> benchmarkNames(int count);

/// Answers every displacement at once while the returned subscribers exist. It has the topics and messages of the node
/// `simulate`, single and bundled, but no components. So its latency is a lower bound for any node.
std::vector<ros::Subscriber> echo(ros::NodeHandle& handle, const std::vector<std::string>& components);

/// Round-trip times of one run [s].
struct RoundTrips {
  std::vector<double> durations;  ///< sorted
  std::size_t sent = 0;
  std::size_t surplus = 0;  ///< answers without a sample, and second answers to a sample
  double elapsed = 0.0;     ///< duration of the run [s]

  /// Returns a quantile of the durations [s], or 0 if there are none.
  double quantile(double fraction) const { return durations.empty() ? 0.0 : numerics::quantileOf(durations, fraction); }
  std::size_t lost() const { return sent - durations.size(); }
};

/// Sends samples to a node in a namespace from the calling thread, and receives answers in another thread. Stamps are 1
/// ms apart, and continue from run to run.
class RoundTripMeter {
 public:
  /// If `bundled`, all components share the messages of the topics `displacements` and `forces`. If `measured`, each
  /// displacement is followed by a measured force of a spring with friction. Waits until every topic is connected, or
  /// throws std::runtime_error after a time limit.
  RoundTripMeter(const std::string& space, const std::vector<std::string>& components, bool bundled,
                 bool measured = false);
  ~RoundTripMeter();

  /// Sends samples to all components at once at a `rate` [Hz] for a `duration` [s].
  RoundTrips atRate(double rate, double duration);

  /// Sends samples for a `duration` [s] as fast as answers arrive, with `under_way` unanswered samples of each
  /// component, and at most `most` samples of each component in total.
  RoundTrips flood(double duration, std::size_t under_way, std::uint64_t most);

 private:
  struct Link;

  // Sends samples while isDue(number in this run, time since its start) returns true.
  template <class Due>
  RoundTrips run(std::uint64_t most, Due isDue);
  std::size_t answered() const;

  ros_interface::ServingThread receiver_;
  std::vector<std::unique_ptr<Link>> links_;
  std::uint64_t next_ = 0;  // number of the next sample
};

/// The program of a node: the echo node, `simulate`, or `simulate` with ~diagnose.
enum class NodeKind { echo, plain, diagnosing };

/// A node in a namespace of its own, and the meter that sends its samples. Requires a master.
class BenchmarkNode {
 public:
  /// Starts the program in the folder of this program, and waits until the node serves. If `measured`, forces are sent
  /// as well. Throws std::runtime_error.
  BenchmarkNode(NodeKind kind, int components, bool bundled = false, bool measured = false);

  RoundTripMeter& meter() { return meter_; }
  pid_t process() const { return process_.id(); }

 private:
  TemporaryFile file_;
  ros_interface::ChildProcess process_;
  RoundTripMeter meter_;
};

}  // namespace rubber_suspension::benchmark
