// The nodes that a benchmark measures, each in a process of its own with generated components, and round trips through
// them from a displacement to its force, at a rate or as fast as possible.
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

/// Returns a component file with `count` components, alternately five Maxwell elements and Berg's model.
std::string benchmarkComponents(int count);

/// Returns the names of these components in the order of the file.
std::vector<std::string> benchmarkNames(int count);

/// Answers every displacement at once while the subscribers exist, which is the lower bound of any node's latency. Has
/// the topics and messages of the node `simulate`, single and bundled, but no components.
std::vector<ros::Subscriber> echo(ros::NodeHandle& handle, const std::vector<std::string>& components);

/// Round trips of one run [s].
struct RoundTrips {
  std::vector<double> durations;  ///< sorted
  std::size_t sent = 0;
  std::size_t surplus = 0;  ///< answers without a sample, or beyond the first
  double elapsed = 0.0;     ///< [s]

  /// Returns 0 if there are no round trips.
  double quantile(double fraction) const { return durations.empty() ? 0.0 : numerics::quantileOf(durations, fraction); }
  std::size_t lost() const { return sent - durations.size(); }
};

/// Drives the components of a node in a namespace: sends in the calling thread and receives in one of its own. Stamps
/// continue from run to run, a millisecond apart.
class RoundTripMeter {
 public:
  /// With `bundled`, all components share the messages of the topics `displacements` and `forces`. With `measured`,
  /// each single displacement is followed by a measured force, that of a spring with friction. Waits until every topic
  /// is connected; throws std::runtime_error if one is not in time.
  RoundTripMeter(const std::string& space, const std::vector<std::string>& components, bool bundled,
                 bool measured = false);
  ~RoundTripMeter();

  /// Sends to all components at once at a `rate` [Hz], for a `duration` [s].
  RoundTrips atRate(double rate, double duration);

  /// Sends for a `duration` [s] as fast as answers come, with `under_way` unanswered samples of each component, and at
  /// most `most` samples of each in total.
  RoundTrips flood(double duration, std::size_t under_way, std::uint64_t most);

 private:
  struct Link;

  // Sends samples while isDue(number in this run, time since its start) holds.
  template <class Due>
  RoundTrips run(std::uint64_t most, Due isDue);
  std::size_t answered() const;

  ros_interface::ServingThread receiver_;
  std::vector<std::unique_ptr<Link>> links_;
  std::uint64_t next_ = 0;  // number of the next sample
};

/// The program to start: an echo node, or `simulate` without or with ~diagnose.
enum class NodeKind { echo, plain, diagnosing };

/// A node in a namespace of its own, with its driver. Needs a master.
class BenchmarkNode {
 public:
  /// Starts the program in the folder of the running one and waits until it serves; `measured` adds measured forces.
  /// Throws std::runtime_error.
  BenchmarkNode(NodeKind kind, int components, bool bundled = false, bool measured = false);

  RoundTripMeter& meter() { return meter_; }
  pid_t process() const { return process_.id(); }

 private:
  TemporaryFile file_;
  ros_interface::ChildProcess process_;
  RoundTripMeter meter_;
};

}  // namespace rubber_suspension::benchmark
