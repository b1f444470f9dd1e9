// What the node tells about itself once per second: /diagnostics and, if something went wrong, one line of log.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <rubber_suspension/Gap.h>

#include <chrono>
#include <string>
#include <vector>

#include "node/component_channel.h"
#include "node/live_gap.h"
#include "ros_interface/bundle_server.h"

namespace rubber_suspension::ros_interface {

/// What is worth a log line between two reports of one channel; empty if nothing is.
std::string describeFaults(const node::ChannelReport& before, const node::ChannelReport& now);

/// Write a report as the diagnostic status of a component; `elapsed` is the time since the report before [s].
void fillStatus(const node::ChannelReport& before, const node::ChannelReport& now, double elapsed,
                diagnostic_updater::DiagnosticStatusWrapper& status);

/// Add the live gap to the status of its component.
void addGap(const node::LiveGap& gap, const node::MatchCounters& counters, const node::GapSettings& settings,
            diagnostic_updater::DiagnosticStatusWrapper& status);

/// The live gap as a message.
Gap gapMessage(const node::LiveGap& gap, const node::GapSettings& settings);

/// Publishes on a timer of steady time, so that it goes on while simulated time stands still.
class NodeDiagnostics {
 public:
  /// The channels must outlive the object.
  NodeDiagnostics(ros::NodeHandle& handle, ros::NodeHandle& private_handle,
                  const std::vector<node::ComponentChannel*>& channels, const node::GapSettings& gap_settings);

  /// Report on the bundled topics, too. The server must outlive the object.
  void watch(const BundleServer& bundle);

 private:
  struct Watched {
    node::ComponentChannel* channel;
    node::ChannelReport before;
    node::ChannelReport now;
    node::GapTracker tracker;
    node::MatchCounters matches;
    node::LiveGap gap;
    ros::Publisher publisher;
  };

  void update();
  void updateGaps();

  node::GapSettings gap_settings_;
  std::vector<Watched> watched_;
  std::size_t next_gap_ = 0;  // whose gap is measured next
  diagnostic_updater::Updater updater_;
  std::chrono::steady_clock::time_point last_update_;
  double elapsed_ = 1.0;  // between the last two updates [s]
  ros::WallTimer timer_;
};

}  // namespace rubber_suspension::ros_interface
