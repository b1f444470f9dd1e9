// The nodes as a benchmark runs them, a process of its own with components made for the purpose, and round trips
// through them: displacement sent to force received, at a rate or as fast as they go.
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

/// A component file with that number of components: by turns five Maxwell elements and Berg's model.
std::string benchmarkComponents(int count);

/// Names of these components, in the order of the file.
std::vector<std::string> benchmarkNames(int count);

/// Answers every displacement at once, as long as the subscribers are held: the floor that the transport sets to any
/// node's latency. Same topics and messages as the node `simulate`, single and bundled, but no component behind them.
std::vector<ros::Subscriber> echo(ros::NodeHandle& handle, const std::vector<std::string>& components);

/// Round trips of one run [s], and whether any was lost.
struct RoundTrips {
  std::vector<double> durations;  ///< sorted
  std::size_t sent = 0;
  std::size_t surplus = 0;  ///< answers to nothing that was sent, or answered already
  double elapsed = 0.0;     ///< [s]

  /// 0 without any.
  double quantile(double fraction) const { return durations.empty() ? 0.0 : numerics::quantileOf(durations, fraction); }
  std::size_t lost() const { return sent - durations.size(); }
};

/// Drives the components of a node in a namespace. Sends in the calling thread, receives in one of its own. The stamps
/// go on from run to run, a millisecond from sample to sample.
class RoundTripMeter {
 public:
  /// With `bundled` all components go in one message of the topics `displacements` and `forces`. With `measured` each
  /// displacement that has a topic of its own is followed by a measured force: that of a spring with friction.
  /// Waits until every topic is connected. Throws std::runtime_error where that does not come about.
  RoundTripMeter(const std::string& space, const std::vector<std::string>& components, bool bundled,
                 bool measured = false);
  ~RoundTripMeter();

  /// Send to all components at once, `rate` times a second [Hz], for a time [s].
  RoundTrips atRate(double rate, double duration);

  /// Send for a time [s] as fast as answers come, that many samples of each component under way and
  /// `most` of each in all.
  RoundTrips flood(double duration, std::size_t under_way, std::uint64_t most);

 private:
  struct Link;

  // Sends sample after sample as long as isDue(number in this run, time since its start) holds.
  template <class Due>
  RoundTrips run(std::uint64_t most, Due isDue);
  std::size_t answered() const;

  ros_interface::ServingThread receiver_;
  std::vector<std::unique_ptr<Link>> links_;
  std::uint64_t next_ = 0;  // number of the next sample
};

/// The program to run: an echo node, or `simulate` without or with ~diagnose.
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
