// What the node tells about itself once per second.
#include "rubber_suspension/ros_interface/node_diagnostics.h"

#include <fmt/format.h>
#include <ros/console.h>

namespace rubber_suspension {
namespace {

constexpr std::size_t kLongestLine = 2000;

void append(std::string& text, std::uint64_t before, std::uint64_t now, const char* what) {
  if (now > before) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", now - before, what);
  }
}

double microseconds(double seconds) { return 1e6 * seconds; }

}  // namespace

std::string describeFaults(const ChannelReport& before, const ChannelReport& now) {
  const StreamCounters& old = before.counters;
  const StreamCounters& fresh = now.counters;
  std::string text;
  append(text, old.not_finite, fresh.not_finite, "not finite (dropped)");
  append(text, old.repeated, fresh.repeated, "with a repeated stamp (dropped)");
  append(text, old.stepped_back, fresh.stepped_back, "with a stamp that steps back (dropped)");
  append(text, before.lost, now.lost, "lost before they arrived");
  append(text, before.disabled, now.disabled, "while disabled (dropped)");
  append(text, old.restarted, fresh.restarted, "jumps back of more than a second (reset)");
  append(text, old.bridged, fresh.bridged, "gaps longer than max_gap (bridged)");
  return text;
}

void fillStatus(const ChannelReport& before, const ChannelReport& now, double elapsed,
                diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const StreamCounters& counters = now.counters;
  const double rate = static_cast<double>(counters.accepted - before.counters.accepted) / elapsed;
  const std::string faults = describeFaults(before, now);
  if (!faults.empty()) {
    status.summary(DiagnosticStatus::WARN, faults);
  } else if (!now.enabled) {
    status.summary(DiagnosticStatus::OK, "disabled");
  } else {
    status.summary(DiagnosticStatus::OK, rate > 0.0 ? "serving" : "waiting for samples");
  }
  status.add("rate [Hz]", rate);
  status.add("accepted", counters.accepted);
  status.add("dropped", counters.dropped() + now.disabled);
  status.add("dropped, not finite", counters.not_finite);
  status.add("dropped, repeated stamp", counters.repeated);
  status.add("dropped, stepped back", counters.stepped_back);
  status.add("dropped, disabled", now.disabled);
  status.add("lost before arrival", now.lost);
  status.add("restarts", counters.restarted);
  status.add("gaps bridged", counters.bridged);
  status.add("latency median [us]", microseconds(now.latency.percentile(0.5)));
  status.add("latency 99 % [us]", microseconds(now.latency.percentile(0.99)));
  status.add("latency maximum [us]", microseconds(now.latency.maximum()));
  status.add("last stamp [s]", fmt::format("{:.9f}", now.last_time));
  status.add("last displacement [m]", now.displacement);
}

NodeDiagnostics::NodeDiagnostics(ros::NodeHandle& handle, ros::NodeHandle& private_handle,
                                 const std::vector<ComponentChannel*>& channels)
    : updater_(handle, private_handle, private_handle.getNamespace()), last_update_(std::chrono::steady_clock::now()) {
  updater_.setHardwareID("none");
  watched_.reserve(channels.size());  // the tasks refer to the entries
  for (ComponentChannel* channel : channels) {
    watched_.push_back({channel, channel->report(), {}});
    const Watched& watched = watched_.back();
    updater_.add(channel->name(), [this, &watched](diagnostic_updater::DiagnosticStatusWrapper& status) {
      fillStatus(watched.before, watched.now, elapsed_, status);
    });
  }
  timer_ = handle.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { update(); });
}

void NodeDiagnostics::update() {
  const auto now = std::chrono::steady_clock::now();
  elapsed_ = std::chrono::duration<double>(now - last_update_).count();
  last_update_ = now;
  std::string line;
  for (Watched& watched : watched_) {
    watched.now = watched.channel->report();
    const std::string faults = describeFaults(watched.before, watched.now);
    if (!faults.empty() && line.size() < kLongestLine) {
      line += fmt::format("{}{}: {}", line.empty() ? "" : "; ", watched.channel->name(), faults);
    }
  }
  updater_.force_update();
  for (Watched& watched : watched_) {
    watched.before = watched.now;
  }
  if (!line.empty()) {
    ROS_WARN("samples: %s", line.c_str());
  }
}

}  // namespace rubber_suspension
