// What the node tells about itself once per second: /diagnostics and, if something went wrong, one line of log.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <rubber_suspension/Gap.h>

#include <chrono>
#include <string>
#include <vector>

#include "rubber_suspension/ros_interface/bundle_server.h"
#include "rubber_suspension/ros_interface/component_channel.h"
#include "rubber_suspension/ros_interface/live_gap.h"

namespace rubber_suspension {

/// What is worth a log line between two reports of one channel; empty if nothing is.
std::string describeFaults(const ChannelReport& before, const ChannelReport& now);

/// Write a report as the diagnostic status of a component; `elapsed` is the time since the report before [s].
void fillStatus(const ChannelReport& before, const ChannelReport& now, double elapsed,
                diagnostic_updater::DiagnosticStatusWrapper& status);

/// Add the live gap to the status of its component.
void addGap(const LiveGap& gap, const MatchCounters& counters, const GapSettings& settings,
            diagnostic_updater::DiagnosticStatusWrapper& status);

/// The live gap as a message.
Gap gapMessage(const LiveGap& gap, const GapSettings& settings);

/// Publishes on a timer of steady time, so that it goes on while simulated time stands still.
class NodeDiagnostics {
 public:
  /// The channels must outlive the object.
  NodeDiagnostics(ros::NodeHandle& handle, ros::NodeHandle& private_handle,
                  const std::vector<ComponentChannel*>& channels, const GapSettings& gap_settings);

  /// Report on the bundled topics, too. The server must outlive the object.
  void watch(const BundleServer& bundle);

 private:
  struct Watched {
    ComponentChannel* channel;
    ChannelReport before;
    ChannelReport now;
    GapTracker tracker;
    MatchCounters matches;
    LiveGap gap;
    ros::Publisher publisher;
  };

  void update();
  void updateGaps();

  GapSettings gap_settings_;
  std::vector<Watched> watched_;
  std::size_t next_gap_ = 0;  // whose gap is measured next
  diagnostic_updater::Updater updater_;
  std::chrono::steady_clock::time_point last_update_;
  double elapsed_ = 1.0;  // between the last two updates [s]
  ros::WallTimer timer_;
};

}  // namespace rubber_suspension
