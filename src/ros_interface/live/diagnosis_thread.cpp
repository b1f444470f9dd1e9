// The live diagnosis of all components in a thread of its own.
#include "ros_interface/live/diagnosis_thread.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pthread.h>
#include <ros/console.h>
#include <rubber_suspension/Diagnosis.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cmath>

#include "element/largest_number.h"
#include "element/refuse.h"
#include "io/cancellation.h"

namespace rubber_suspension::ros_interface {
namespace {

constexpr std::chrono::milliseconds kPause(200);
constexpr std::size_t kPiece = 4096;  // samples that are read at a time

std::unique_ptr<diagnosis::live::LiveDiagnosis> liveDiagnosis(const io::ComponentDescription& configured,
                                                              const LiveDiagnoserSettings& settings) {
  diagnosis::live::LiveSettings live;
  live.memory = static_cast<std::size_t>(settings.memory);
  return std::make_unique<diagnosis::live::LiveDiagnosis>(configured, live);
}

Diagnosis diagnosisMessage(const diagnosis::live::LiveFindings& findings) {
  Diagnosis message;
  message.header.stamp.fromNSec(static_cast<std::uint64_t>(findings.stamp));
  message.verdict = toString(findings.now);
  message.effects = findings.now.effects;
  if (findings.now.effects.size() == findings.probabilities.size()) {
    message.probabilities = findings.probabilities;
    message.confounded = findings.now.effects.empty() ? std::vector<std::string>() : findings.confounded;
  }
  message.gap_as_configured = findings.gap.as_configured;
  message.gap_augmented = findings.gap.augmented;
  message.noise_floor = findings.gap.noise_floor;
  message.where = findings.where;
  message.rig_findings = findings.rig_findings;
  message.since_known = static_cast<std::uint8_t>(findings.now.since.has_value());
  message.since.fromNSec(static_cast<std::uint64_t>(findings.now.since.value_or(0)));
  message.evidence = findings.now.evidence;
  message.evidence_needed = findings.now.threshold;
  message.samples = static_cast<std::uint32_t>(findings.samples);
  message.window = findings.window;
  message.sentence = findings.sentence;
  return message;
}

}  // namespace

DiagnosisThread::DiagnosisThread(ros::NodeHandle& handle, const std::vector<node::ComponentChannel*>& channels,
                                 const LiveDiagnoserSettings& settings)
    : settings_(settings) {
  for (node::ComponentChannel* channel : channels) {
    io::checkCancelled();
    const auto configured = channel->configured();
    Watched& watched = watched_[channel->name()];
    watched = {channel, configured, liveDiagnosis(*configured, settings_), 0,
               handle.advertise<Diagnosis>(channel->name() + "/diagnosis", 10, true)};
    watched.findings = watched.live->findings();
    watched.publisher.publish(diagnosisMessage(watched.findings));
  }
  thread_ = std::thread([this] { run(); });
  pthread_setname_np(thread_.native_handle(), "diagnosis");
}

DiagnosisThread::~DiagnosisThread() { DiagnosisThread::stop(); }

void DiagnosisThread::stop() {
  if (thread_.joinable()) {
    stopping_ = true;
    wake_.set_value();
    thread_.join();
  }
}

// Sets the niceness of this thread alone, which Linux permits.
void DiagnosisThread::run() {
  if (setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), settings_.nice) != 0) {
    ROS_WARN("the priority of the live diagnosis cannot be lowered; it runs at normal priority");
  }
  const std::future<void> woken = wake_.get_future();
  do {
    for (auto& [name, watched] : watched_) {
      try {
        serve(watched);
      } catch (const io::Cancelled&) {
        return;
      } catch (const std::exception& error) {
        ROS_ERROR_THROTTLE(60.0, "live diagnosis of %s: %s", name.c_str(), error.what());
      }
    }
  } while (woken.wait_for(kPause) == std::future_status::timeout);
}

void DiagnosisThread::serve(Watched& watched) {
  auto configured = watched.channel->configured();
  if (configured != watched.configured) {  // the component file was read again
    watched.configured = std::move(configured);
    watched.live = liveDiagnosis(*watched.configured, settings_);
  }
  std::vector<node::MatchedSample> samples;
  do {
    samples = watched.channel->gap().read(watched.next, kPiece);
    for (const node::MatchedSample& sample : samples) {
      watched.live->add({sample.stamp, sample.displacement, sample.measured});
    }
  } while (samples.size() >= kPiece && !stopping_);
  tell(watched);
  if (watched.live->lookIsDue()) {
    watched.live->look([this] { return stopping_.load(); });
    tell(watched);
  }
}

void DiagnosisThread::tell(Watched& watched) {
  diagnosis::live::LiveFindings findings = watched.live->findings();
  if (findings.looks == 0 && watched.channel->gap().counters().not_finite > 0) {
    findings.sentence += fmt::format(
        "; measured forces were dropped; accepted: finite forces of magnitude {:g} N at most", element::kLargestNumber);
  }
  auto found = watched.live->found();
  const diagnosis::live::LiveVerdict& told = watched.findings.now;
  const bool other = told.verdict != findings.now.verdict || told.effects != findings.now.effects;
  const bool reason =
      findings.looks == 0 && watched.findings.sentence != findings.sentence;  // why there is no diagnosis yet
  const bool news = other || reason || told.since != findings.now.since || watched.findings.looks != findings.looks;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    watched.findings = findings;
    watched.found = std::move(found);
  }
  if (news) {
    watched.publisher.publish(diagnosisMessage(findings));
  }
  if (other && findings.now.verdict) {
    ROS_INFO("%s: %s: %s", watched.channel->name().c_str(), toString(findings.now).c_str(), findings.sentence.c_str());
  }
}

io::ComponentDescription DiagnosisThread::found(const std::string& component) const {
  const Watched& watched = watched_.at(component);
  const std::lock_guard<std::mutex> lock(mutex_);
  element::refuseIf(!watched.found, "{}: there is no model to promote; the verdict of the live diagnosis is `{}`: {}",
                    component, toString(watched.findings.now), watched.findings.sentence);
  return *watched.found;
}

void DiagnosisThread::fillStatus(const std::string& component,
                                 diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const Watched& watched = watched_.at(component);
  const std::lock_guard<std::mutex> lock(mutex_);
  const diagnosis::live::LiveFindings& findings = watched.findings;
  using diagnostic_msgs::DiagnosticStatus;
  const std::string verdict = toString(findings.now);
  const auto level =
      findings.now.verdict == diagnosis::Verdict::check_bench || findings.now.verdict == diagnosis::Verdict::defect
          ? DiagnosticStatus::ERROR
      : findings.now.isGap() ? DiagnosticStatus::WARN
                             : DiagnosticStatus::OK;
  status.summary(level, findings.now.effects.empty()
                            ? verdict
                            : fmt::format("{}: {}", verdict, fmt::join(findings.now.effects, ", ")));
  status.add("sentence", findings.sentence);
  status.add("looks", findings.looks);
  status.add("window [s]", findings.window);
  if (std::isfinite(findings.gap.as_configured)) {  // false before the first diagnosis
    status.add("gap as configured", findings.gap.as_configured);
    status.add("gap with the effects found", findings.gap.augmented);
    status.add("noise floor", findings.gap.noise_floor);
  }
  status.add("evidence", fmt::format("{:.3g} of {:.3g}", findings.now.evidence, findings.now.threshold));
  if (findings.now.since) {
    status.add("since [s]", fmt::format("{:.3f}", 1e-9 * static_cast<double>(*findings.now.since)));
  }
}

}  // namespace rubber_suspension::ros_interface

extern "C" rubber_suspension::ros_interface::LiveDiagnoser* rubber_suspension_make_live_diagnoser(
    ros::NodeHandle& handle, const std::vector<rubber_suspension::node::ComponentChannel*>& channels,
    const rubber_suspension::ros_interface::LiveDiagnoserSettings& settings) {
  return new rubber_suspension::ros_interface::DiagnosisThread(handle, channels, settings);
}
