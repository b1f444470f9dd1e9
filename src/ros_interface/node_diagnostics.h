// The node's report about itself, once per second: /diagnostics and, if something went wrong, a line of log.
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

/// Write the status of a serving thread that came round so long ago [s]: stale where something holds it up.
void fillThreadStatus(const std::string& name, double silence, diagnostic_updater::DiagnosticStatusWrapper& status);

/// Publishes on a timer of steady time, so that it continues while simulated time stands still.
class NodeDiagnostics {
 public:
  NodeDiagnostics(ros::NodeHandle& handle, ros::NodeHandle& private_handle, const node::GapSettings& gap_settings);

  /// Report on a component, the bundled topics or a serving thread. All of these must outlive the object.
  void watch(node::ComponentChannel& channel, const SampleServer& server);
  void watch(const BundleServer& bundle, const std::string& name);
  void watch(const ServingThread& thread);

  /// Report on what the live diagnosis says of a component.
  void watch(const LiveDiagnoser& live, const std::string& component);

 private:
  // A live gap of a component, of a direction of it or the only one.
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
    std::vector<Gap> gaps;             // one, or those of six directions
    std::optional<Gap> shadow;         // of one direction
    ros::Publisher running_publisher;  // latched
    node::RunningModel running;
    node::ChannelReport before{};
    node::ChannelReport now{};
    node::ChannelReport logged{};  // as of the last line of log
    node::MatchCounters matches{};
  };

  void watchGaps(Watched& watched);

  void update();
  void updateGaps();
  static void updateRunning(Watched& watched);
  void logFaults(double now);

  ros::NodeHandle handle_;
  node::GapSettings gap_settings_;
  std::deque<Watched> watched_;  // the tasks refer to the entries
  node::ReportPace pace_;
  std::size_t next_gap_ = 0;  // whose gap is measured next
  diagnostic_updater::Updater updater_;
  std::chrono::steady_clock::time_point last_update_;
  double elapsed_ = 1.0;  // between the last two updates [s]
  ros::WallTimer timer_;
};

}  // namespace rubber_suspension::ros_interface
