// Plays a log through a running node.
#include "rubber_suspension/ros_interface/log_player.h"

#include <fmt/format.h>
#include <ros/init.h>

#include <algorithm>

#include "rubber_suspension/io/progress.h"
#include "rubber_suspension/ros_interface/bag_log.h"
#include "rubber_suspension/ros_interface/connection.h"

namespace rubber_suspension {
namespace {

constexpr std::uint32_t kQueueSize = 100000;

double seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

std::size_t PlayResult::answered() const {
  return static_cast<std::size_t>(
      std::count_if(answers.begin(), answers.end(), [](std::uint32_t count) { return count > 0; }));
}

bool PlayResult::exactlyOneEach() const {
  return unexpected == 0 && std::all_of(answers.begin(), answers.end(), [](std::uint32_t count) { return count == 1; });
}

LogPlayer::LogPlayer(const ros::NodeHandle& handle, const PlayOptions& options) : options_(options), handle_(handle) {
  handle_.setCallbackQueue(&queue_);
  const std::string& component = options_.component;
  displacement_publisher_ = handle_.advertise<Displacement>(component + "/displacement", kQueueSize);
  measured_force_publisher_ = handle_.advertise<MeasuredForce>(component + "/measured_force", kQueueSize);
  const boost::function<void(const boost::shared_ptr<const Force>&)> callback =
      [this](const boost::shared_ptr<const Force>& force) { take(*force); };
  subscriber_ = handle_.subscribe<Force>(component + "/force", kQueueSize, callback, ros::VoidConstPtr(),
                                         ros::TransportHints().tcpNoDelay());
}

void LogPlayer::connect() {
  const auto end = Steady::now() + std::chrono::duration<double>(options_.connect_timeout);
  bool connected = waitForPublishers(subscriber_.getTopic(), options_.connect_timeout);
  while (connected && displacement_publisher_.getNumSubscribers() == 0) {
    connected = Steady::now() < end && ros::ok();
    ros::WallDuration(0.01).sleep();
  }
  if (!connected) {
    throw PlayError(
        fmt::format("no node serves {} within {:g} s", displacement_publisher_.getTopic(), options_.connect_timeout));
  }
}

void LogPlayer::take(const Force& force) {
  last_answer_ = Steady::now();
  if (log_ == nullptr) {
    return;
  }
  const std::int64_t stamp = static_cast<std::int64_t>(force.header.stamp.toNSec()) - shift_;
  const auto end = log_->stamp.begin() + static_cast<std::ptrdiff_t>(result_.sent);
  const auto found = std::lower_bound(log_->stamp.begin(), end, stamp);
  if (found == end || *found != stamp) {
    ++result_.unexpected;
    return;
  }
  const auto sample = static_cast<std::size_t>(found - log_->stamp.begin());
  if (++result_.answers[sample] == 1) {
    result_.force[sample] = {force.force, force.elastic, force.viscous, force.friction};
    ++answered_;
  }
}

double LogPlayer::untilDue() const {
  if (options_.rate <= 0.0) {
    return 0.0;
  }
  const double due = 1e-9 * static_cast<double>(log_->stamp[result_.sent] - log_->stamp.front()) / options_.rate;
  return due - seconds(Steady::now() - start_);
}

bool LogPlayer::maySend() const {
  return result_.sent < log_->size() && result_.sent - answered_ < options_.in_flight && untilDue() <= 0.0;
}

void LogPlayer::send() {
  const std::size_t sample = result_.sent++;
  Displacement displacement;
  displacement.header.stamp = toRosTime(log_->stamp[sample] + shift_);
  displacement.displacement = log_->displacement[sample];
  displacement_publisher_.publish(displacement);
  if (!log_->force.empty()) {
    MeasuredForce force;
    force.header.stamp = displacement.header.stamp;
    force.force = log_->force[sample];
    measured_force_publisher_.publish(force);
  }
}

void LogPlayer::lingerForSurplus() {
  // Answers to one sample too many would follow at once; this is a multiple of a round trip.
  constexpr double kLinger = 0.2;
  const auto end = Steady::now() + std::chrono::duration<double>(kLinger);
  while (Steady::now() < end) {
    queue_.callAvailable(ros::WallDuration(0.05));
  }
}

PlayResult LogPlayer::play(const Log& log) {
  checkLog(log);
  connect();
  log_ = &log;
  shift_ = headerShift(log);
  result_ = PlayResult();
  result_.force.resize(log.size());
  result_.answers.resize(log.size());
  answered_ = 0;
  Progress progress("playing " + log.name, log.size());
  start_ = last_answer_ = Steady::now();
  while (ros::ok() && answered_ < log.size()) {
    while (maySend()) {
      send();
      progress.advance();
    }
    const bool waits_for_answer = result_.sent > answered_;
    const double wait = result_.sent < log.size() ? std::clamp(untilDue(), 0.0, 0.05) : 0.05;
    queue_.callAvailable(ros::WallDuration(wait > 0.0 || !waits_for_answer ? wait : 0.05));
    if (!waits_for_answer) {
      last_answer_ = Steady::now();
    } else if (seconds(Steady::now() - last_answer_) > options_.answer_timeout) {
      break;
    }
  }
  result_.duration = seconds(last_answer_ - start_);
  lingerForSurplus();
  log_ = nullptr;
  return result_;
}

}  // namespace rubber_suspension
