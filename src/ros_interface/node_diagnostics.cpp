// Diagnostics of the node, once per second.
#include "ros_interface/node_diagnostics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ros/console.h>
#include <rubber_suspension/Gap.h>
#include <rubber_suspension/Running.h>

#include <algorithm>
#include <utility>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::ros_interface {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;
using node::ChannelReport;

constexpr std::size_t kLongestLine = 2000;
constexpr std::size_t kMostCells = 20;

// A count of faults of a component, with the names that it has on /diagnostics and in a warning.
struct Fault {
  const char* row;
  const char* words;
  std::uint64_t ChannelReport::* count;
};

constexpr Fault kFaults[] = {
    {"dropped, not finite", "not finite (dropped)", &ChannelReport::not_finite},
    {"dropped, force not finite", "force not finite (dropped)", &ChannelReport::force_not_finite},
    {"dropped, repeated stamp", "with a repeated stamp (dropped)", &ChannelReport::repeated},
    {"dropped, stepped back", "with a stamp that steps back (dropped)", &ChannelReport::stepped_back},
    {"dropped, no rotation", "with a quaternion whose length is not 1 (dropped)", &ChannelReport::not_a_rotation},
    {"dropped, beyond measure", "with a rotation that exceeds the range of its measure (dropped)",
     &ChannelReport::beyond_measure},
    {"dropped, disabled", "while disabled (dropped)", &ChannelReport::disabled},
    {"dropped, undecodable", "that cannot be decoded (dropped)", &ChannelReport::undecodable},
    {"lost before arrival", "lost before they arrived", &ChannelReport::lost},
    {"forces not delivered", "forces not delivered: a subscriber reads too slowly", &ChannelReport::undelivered},
    {"restarts", "jumps back of more than a second (reset)", &ChannelReport::restarted},
    {"time gaps bridged", "time gaps longer than max_gap (bridged)", &ChannelReport::bridged},
    {"beyond valid displacement", "beyond valid_displacement (served)", &ChannelReport::beyond_valid},
    {"beyond valid rotation", "beyond valid_rotation (served)", &ChannelReport::beyond_rotation},
    {"temperatures, refused", "temperatures refused: not finite, or outside the range of the component's shift",
     &ChannelReport::refused_temperatures},
};

// Returns the words of a fault. If stamps of 0 are repeated, the sender does not set them; the remedy is then added.
std::string wordsOf(const Fault& fault, const ChannelReport& before, const ChannelReport& now) {
  if (fault.count != &ChannelReport::repeated || !now.started || now.last_time != 0.0) {
    return fault.words;
  }
  std::string text = "with an empty header, whose stamp is 0 (dropped)";
  if (before.repeated == 0) {
    text +=
        ": the sender must fill the header; rostopic pub does this with 'header: auto', and a driver that sends "
        "Float64 needs a message with a header, such as Float64Stamped, whose stamp is copied into Displacement";
  }
  return text;
}

// Returns a description of the faults of a component between two reports, or an empty text if there are none.
std::string describeFaults(const ChannelReport& before, const ChannelReport& now) {
  std::string text;
  for (const Fault& fault : kFaults) {
    const std::uint64_t news = now.*fault.count - before.*fault.count;
    if (news > 0) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", news, wordsOf(fault, before, now));
    }
  }
  if (now.beyond_valid > before.beyond_valid && now.valid) {
    text += fmt::format("; valid: {:g} to {:g} mm", 1e3 * now.valid->lower, 1e3 * now.valid->upper);
  }
  if (now.beyond_rotation > before.beyond_rotation) {
    text += fmt::format("; valid: up to {:g} deg", now.valid_rotation * 180.0 / element::kPi);
  }
  return text;
}

void fillStatus(const ChannelReport& before, const ChannelReport& now, double elapsed,
                DiagnosticStatusWrapper& status) {
  const double rate = static_cast<double>(now.accepted - before.accepted) / elapsed;
  const std::string faults = describeFaults(before, now);
  status.summary(faults.empty() ? DiagnosticStatus::OK : DiagnosticStatus::WARN, !faults.empty() ? faults
                                                                                 : !now.enabled  ? "disabled"
                                                                                 : rate > 0.0    ? "serving"
                                                                                              : "waiting for samples");
  status.add("rate [Hz]", rate);
  status.add("accepted", now.accepted);
  status.add("dropped", now.dropped() + now.disabled);
  for (const Fault& fault : kFaults) {
    status.add(fault.row, now.*fault.count);
  }
  status.add("latency median [us]", 1e6 * now.latency.percentile(0.5));
  status.add("latency 99 % [us]", 1e6 * now.latency.percentile(0.99));
  status.add("latency maximum [us]", 1e6 * now.latency.maximum());
  status.add("last stamp [s]", fmt::format("{:.9f}", now.last_time));
  if (now.coordinates) {
    status.add("last coordinates [m, rad]",
               fmt::format("{:g}", fmt::join(now.coordinates->data(), now.coordinates->data() + 6, ", ")));
  } else {
    status.add("last displacement [m]", now.displacement);
  }
  if (now.shifts_with_temperature) {
    status.add("temperature [degC]", now.temperature ? fmt::format("{:g}", *now.temperature) : "none received");
  }
}

// Adds the counts of measured forces. Returns false if there is no measured force.
bool addMatches(const node::MatchCounters& counters, DiagnosticStatusWrapper& status) {
  if (counters.matched + counters.unmatched + counters.not_finite == 0) {
    return false;
  }
  status.add("measured forces, matched", counters.matched);
  status.add("measured forces, without sample", counters.unmatched);
  status.add("measured forces, not finite", counters.not_finite);
  return true;
}

// Adds the rows of a live gap, which begin with the direction if there are several directions.
void addGap(const std::string& direction, const node::LiveGap& gap, const node::GapSettings& settings,
            DiagnosticStatusWrapper& status) {
  const std::string of = direction.empty() ? "" : direction + ": ";
  if (!gap.known) {
    status.add(of + "gap", "unknown: " + gap.reason);
    return;
  }
  status.add(of + "gap", gap.gap);
  status.add(of + "gap, as recorded", gap.gap_as_recorded);
  status.add(of + "gap, noise floor", gap.noise_floor);
  status.add(of + "gap, beyond noise", gap.beyond_noise);
  status.add(of + "gap, trend [1/s]", gap.trend);
  status.add(of + "ISO/TS 18571",
             fmt::format("{:.3f} ({}){}", gap.iso18571.total, gap::iso18571Grade(gap.iso18571.total),
                         gap.iso18571.repeats ? "; the measured force is periodic" : ""));
  for (std::size_t i = 0; i < gap.share.size(); ++i) {
    status.add(of + "gap, share of " + gap::toString(static_cast<gap::Quantity>(i)), gap.share[i]);
  }
  for (const measurement::RigFinding& finding : gap.rig_findings) {
    status.add(of + "rig, " + finding.finding, finding.text);
  }
  const node::GapLevel level = gap.level(settings);
  if (level == node::GapLevel::warn || level == node::GapLevel::error) {
    status.mergeSummaryf(level == node::GapLevel::warn ? DiagnosticStatus::WARN : DiagnosticStatus::ERROR,
                         "%sgap of %.3g beyond noise", of.c_str(), gap.beyond_noise);
  }
}

rubber_suspension::Gap gapMessage(const node::LiveGap& gap, const node::GapSettings& settings) {
  rubber_suspension::Gap message;
  message.header.stamp.fromNSec(static_cast<std::uint64_t>(gap.stamp));
  message.level = static_cast<std::uint8_t>(gap.level(settings));
  message.window = gap.window;
  message.samples = static_cast<std::uint32_t>(gap.samples);
  message.gap = gap.gap;
  message.gap_as_recorded = gap.gap_as_recorded;
  message.noise_floor = gap.noise_floor;
  message.beyond_noise = gap.beyond_noise;
  message.trend = gap.trend;
  message.iso18571_total = gap.iso18571.total;
  message.iso18571_corridor = gap.iso18571.corridor;
  message.iso18571_phase = gap.iso18571.phase;
  message.iso18571_magnitude = gap.iso18571.magnitude;
  message.iso18571_slope = gap.iso18571.slope;
  message.iso18571_repeats = gap.iso18571.repeats;
  for (const measurement::RigFinding& finding : gap.rig_findings) {
    message.rig_findings.push_back(finding.text);
  }
  const auto share = [&](gap::Quantity quantity) { return gap.share[static_cast<std::size_t>(quantity)]; };
  message.share_stiffness = share(gap::Quantity::stiffness);
  message.share_loss = share(gap::Quantity::loss);
  message.share_harmonics = share(gap::Quantity::harmonics);
  message.share_mean = share(gap::Quantity::mean);
  message.share_drift = share(gap::Quantity::drift);
  for (std::size_t i = 0; i < std::min(gap.cells.size(), kMostCells); ++i) {
    const gap::GapCell& cell = gap.cells[i];
    GapShare entry;
    entry.quantity = gap::toString(cell.quantity);
    entry.frequency_low = cell.frequency[0];
    entry.frequency_high = cell.frequency[1];
    entry.amplitude_low = cell.amplitude[0];
    entry.amplitude_high = cell.amplitude[1];
    entry.share = cell.share;
    entry.noise_ratio = cell.noise_ratio;
    message.cells.push_back(entry);
  }
  return message;
}

Running runningMessage(const std::string& component, const node::RunningModel& running) {
  Running message;
  message.header.stamp.fromNSec(static_cast<std::uint64_t>(running.since));
  message.stage = static_cast<std::uint8_t>(running.stage);
  message.component = component;
  const bool in_place = running.stage == node::RunStage::promoting || running.stage == node::RunStage::promoted;
  message.sha256 = in_place ? running.other_sha256 : running.configured_sha256;
  message.other_sha256 = in_place ? running.configured_sha256 : running.other_sha256;
  message.added = running.added;
  message.note = running.note;
  return message;
}

}  // namespace

void fillThreadStatus(const std::string& name, double silence, DiagnosticStatusWrapper& status) {
  constexpr double kStale = 2.0;  // [s]; a thread takes ten turns per second unless it is blocked
  if (silence > kStale) {
    status.summaryf(DiagnosticStatus::STALE, "thread `%s` has not served anything for %.1f s", name.c_str(), silence);
  } else {
    status.summary(DiagnosticStatus::OK, "serving");
  }
  status.add("last round [s ago]", fmt::format("{:.3f}", silence));
}

NodeDiagnostics::NodeDiagnostics(ros::NodeHandle& handle, ros::NodeHandle& private_handle,
                                 const node::GapSettings& gap_settings)
    : handle_(handle),
      gap_settings_(gap_settings),
      updater_(handle, private_handle, private_handle.getNamespace()),
      last_update_(std::chrono::steady_clock::now()) {
  updater_.setHardwareID("none");
  timer_ = handle.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { update(); });
}

void NodeDiagnostics::watchGaps(Watched& watched) {
  const auto gap = [&](const std::string& direction, std::size_t place, const io::ComponentDescription& description,
                       const std::string& topic) -> Gap {
    return {direction, place, node::GapTracker(gap_settings_, description.rig.value_or(io::RigTolerances{})),
            handle_.advertise<rubber_suspension::Gap>(watched.channel->name() + topic, 10)};
  };
  const auto configured = watched.channel->configured();
  if (!configured->six) {
    watched.gaps.push_back(gap("", 0, *configured, "/gap"));
    watched.shadow = gap("", 0, *configured, "/shadow_gap");
  }
  for (std::size_t i = 0; configured->six && i < component::kDirections; ++i) {
    if (const auto& direction = configured->six->directions[i]) {
      const std::string name = component::toString(static_cast<component::Direction>(i));
      watched.gaps.push_back(gap(name, i, *direction, "/" + name + "/gap"));
    }
  }
}

void NodeDiagnostics::watch(node::ComponentChannel& channel, const SampleServer& server) {
  watched_.push_back({&channel,
                      &server,
                      {},
                      {},
                      handle_.advertise<Running>(channel.name() + "/running", 10, true),
                      channel.running()});
  Watched& watched = watched_.back();
  watchGaps(watched);
  watched.running_publisher.publish(runningMessage(channel.name(), watched.running));
  updater_.add(channel.name(), [this, &watched](DiagnosticStatusWrapper& status) {
    fillStatus(watched.before, watched.now, elapsed_, status);
    if (addMatches(watched.matches, status)) {
      for (const Gap& gap : watched.gaps) {
        addGap(gap.direction, gap.gap, gap_settings_, status);
      }
    }
    status.add("running", node::toString(watched.running.stage));
    if (!watched.running.added.empty()) {
      status.add("elements added to the running model", fmt::format("{}", fmt::join(watched.running.added, ", ")));
    }
  });
}

void NodeDiagnostics::watch(const BundleServer& bundle, const std::string& name) {
  updater_.add(name, [&bundle, before = std::uint64_t{0}](DiagnosticStatusWrapper& status) mutable {
    const std::uint64_t wrong = bundle.malformed() + bundle.undecodable() + bundle.lost() + bundle.undelivered();
    if (wrong > before) {
      status.summary(DiagnosticStatus::WARN, fmt::format("{} bundles dropped, lost or not delivered", wrong - before));
    } else {
      status.summary(DiagnosticStatus::OK, "serving");
    }
    before = wrong;
    status.add("answered", bundle.answered());
    status.add("dropped, malformed", bundle.malformed());
    status.add("dropped, undecodable", bundle.undecodable());
    status.add("lost before arrival", bundle.lost());
    status.add("forces not delivered", bundle.undelivered());
  });
}

void NodeDiagnostics::watch(const ServingThread& thread) {
  updater_.add("thread " + thread.name(), [&thread](DiagnosticStatusWrapper& status) {
    fillThreadStatus(thread.name(), thread.silence(), status);
  });
}

void NodeDiagnostics::watch(const LiveDiagnoser& live, const std::string& component) {
  updater_.add("diagnosis of " + component,
               [&live, component](DiagnosticStatusWrapper& status) { live.fillStatus(component, status); });
}

// Measures the gaps in turn for a part of the period, so that with many components each gap is measured less often.
void NodeDiagnostics::updateGaps() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
  for (std::size_t i = 0; i < watched_.size() && std::chrono::steady_clock::now() < end; ++i) {
    Watched& watched = watched_[next_gap_];
    next_gap_ = (next_gap_ + 1) % watched_.size();
    const node::MatchCounters matches = watched.channel->gap().counters();
    const bool news = matches.matched != watched.matches.matched || matches.unmatched != watched.matches.unmatched;
    watched.matches = matches;
    if (!news) {
      continue;
    }
    const auto windows = watched.channel->windows(gap_settings_.window);
    const auto update = [&](Gap& gap, node::SimulatedForce simulated) {
      gap.gap = gap.tracker.update(windows[gap.place], simulated);
      gap.publisher.publish(gapMessage(gap.gap, gap_settings_));
    };
    for (Gap& gap : watched.gaps) {
      update(gap, &node::MatchedSample::simulated);
    }
    if (watched.shadow && !watched.running.other_sha256.empty()) {
      update(*watched.shadow, &node::MatchedSample::beside);
    }
  }
}

void NodeDiagnostics::updateRunning(Watched& watched) {
  const node::RunningModel running = watched.channel->running();
  if (running != watched.running) {
    watched.running = running;
    watched.running_publisher.publish(runningMessage(watched.channel->name(), running));
    ROS_INFO("%s: %s%s%s", watched.channel->name().c_str(), node::toString(running.stage).c_str(),
             running.note.empty() ? "" : ": ", running.note.c_str());
  }
}

void NodeDiagnostics::update() {
  const auto now = std::chrono::steady_clock::now();
  elapsed_ = std::chrono::duration<double>(now - last_update_).count();
  last_update_ = now;
  for (Watched& watched : watched_) {
    watched.now = watched.channel->report();
    watched.now.undecodable = watched.server->undecodable();
    watched.now.undelivered = watched.server->undelivered();
    updateRunning(watched);
  }
  updateGaps();
  updater_.force_update();
  logFaults(std::chrono::duration<double>(now.time_since_epoch()).count());
  for (Watched& watched : watched_) {
    watched.before = watched.now;
  }
}

// Logs all faults since the last line of log if any fault is new.
void NodeDiagnostics::logFaults(double now) {
  const bool news = std::any_of(watched_.begin(), watched_.end(), [](const Watched& watched) {
    return !describeFaults(watched.before, watched.now).empty();
  });
  if (!news || !pace_.isDue(now)) {
    return;
  }
  std::string line;
  for (Watched& watched : watched_) {
    const std::string faults = describeFaults(watched.logged, watched.now);
    if (!faults.empty() && line.size() < kLongestLine) {
      line += fmt::format("{}{}: {}", line.empty() ? "" : "; ", watched.channel->name(), faults);
    }
    watched.logged = watched.now;
  }
  ROS_WARN("samples: %s", line.c_str());
}

}  // namespace rubber_suspension::ros_interface
