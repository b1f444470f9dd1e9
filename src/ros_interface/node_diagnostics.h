// Diagnostics of the node, once per second: a message on /diagnostics and, if there are faults, a line of log.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "node/component_channel.h"
#include "node/live_gap.h"
#include "node/report_pace.h"
#include "ros_interface/bundle_server.h"
#include "ros_interface/live_diagnoser.h"
#include "ros_interface/sample_server.h"
#include "ros_interface/serving_thread.h"

namespace rubber_suspension::ros_interface {

/// Writes the status of a serving thread whose last turn was `silence` [s] ago, `stale` if the thread is blocked.
void fillThreadStatus(const std::string& name, double silence, diagnostic_updater::DiagnosticStatusWrapper& status);

/// Publishes the diagnostics. A wall timer triggers them, so that they continue while simulated time stands still.
class NodeDiagnostics {
 public:
  NodeDiagnostics(ros::NodeHandle& handle, ros::NodeHandle& private_handle, const node::GapSettings& gap_settings);

  /// Adds a component, the bundled topics or a serving thread. The arguments must outlive the object.
  void watch(node::ComponentChannel& channel, const SampleServer& server);
  void watch(const BundleServer& bundle, const std::string& name);
  void watch(const ServingThread& thread);

  /// Adds the findings of the live diagnosis on a component.
  void watch(const LiveDiagnoser& live, const std::string& component);

 private:
  // The live gap of one direction of a component.
  struct Gap {
    std::string direction;
    std::size_t place;
    node::GapTracker tracker;
    ros::Publisher publisher;
    node::LiveGap gap{};
  };

  struct Watched {
    node::ComponentChannel* channel;
    const SampleServer* server;
    std::vector<Gap> gaps;             // a single one, or one for each direction that is not free
    std::optional<Gap> shadow;         // gap of a second model; for components of one direction only
    ros::Publisher running_publisher;  // latched
    node::RunningModel running;
    node::ChannelReport before{};
    node::ChannelReport now{};
    node::ChannelReport logged{};  // report at the last line of log
    node::MatchCounters matches{};
  };

  void watchGaps(Watched& watched);

  void update();
  void updateGaps();
  static void updateRunning(Watched& watched);
  void logFaults(double now);

  ros::NodeHandle handle_;
  node::GapSettings gap_settings_;
  std::deque<Watched> watched_;  // diagnostic tasks refer to the entries
  node::ReportPace pace_;
  std::size_t next_gap_ = 0;  // component whose gap is measured next
  diagnostic_updater::Updater updater_;
  std::chrono::steady_clock::time_point last_update_;
  double elapsed_ = 1.0;  // time between the last two updates [s]
  ros::WallTimer timer_;
};

}  // namespace rubber_suspension::ros_interface
