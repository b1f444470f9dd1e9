// Plays a log through a running node.
#include "ros_interface/log_player.h"

#include <fmt/format.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/init.h>
#include <rubber_suspension/Gap.h>
#include <sensor_msgs/Temperature.h>

#include <algorithm>
#include <cmath>

#include "bag/header_stamp.h"
#include "element/suggestion.h"
#include "io/progress.h"
#include "log/log_columns.h"
#include "log/samples.h"
#include "log/text.h"
#include "ros_interface/connection.h"
#include "ros_interface/pose_messages.h"
#include "rubber_suspension/gap/pose_replay.h"

namespace rubber_suspension::ros_interface {
namespace {

constexpr std::uint32_t kSampleQueueSize = 100000;
constexpr double kNoteEvery = 5.0;            // [s]
constexpr double kPatienceWithOthers = 10.0;  // [s]

double seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

std::chrono::steady_clock::duration toDuration(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
}

// Returns the numbers of an answer: a force with its parts, or a wrench.
std::array<double, 6> numbersOf(const Force& answer) {
  return {answer.force, answer.elastic, answer.viscous, answer.friction};
}

std::array<double, 6> numbersOf(const geometry_msgs::WrenchStamped& answer) {
  const geometry_msgs::Wrench& of = answer.wrench;
  return {of.force.x, of.force.y, of.force.z, of.torque.x, of.torque.y, of.torque.z};
}

}  // namespace

std::size_t PlayResult::answered() const {
  return static_cast<std::size_t>(
      std::count_if(answers.begin(), answers.end(), [](std::uint32_t count) { return count > 0; }));
}

std::vector<double> PlayResult::totals() const {
  std::vector<double> totals;
  for (const element::ComponentForce& answer : force) {
    totals.push_back(answer.total);
  }
  return totals;
}

bool PlayResult::exactlyOneEach() const {
  return unexpected == 0 && std::all_of(answers.begin(), answers.end(), [](std::uint32_t count) { return count == 1; });
}

LogPlayer::LogPlayer(const ros::NodeHandle& handle, const PlayOptions& options) : options_(options), handle_(handle) {
  handle_.setCallbackQueue(&queue_);
  const std::string& component = options_.component;
  if (options_.rotation) {
    open<geometry_msgs::PoseStamped, geometry_msgs::WrenchStamped, geometry_msgs::WrenchStamped>(
        "/pose", "/measured_wrench", "/wrench");
  } else {
    open<Displacement, MeasuredForce, Force>("/displacement", "/measured_force", "/force");
  }
  temperature_publisher_ = handle_.advertise<sensor_msgs::Temperature>(component + "/temperature", kSampleQueueSize);
  if (options_.record_gap) {
    const boost::function<void(const GapConstPtr&)> gap_callback = [this](const GapConstPtr& gap) {
      result_.gaps.push_back(gap);
      result_.gap_stamps.push_back(static_cast<std::int64_t>(gap->header.stamp.toNSec()) - shift_);
    };
    gap_subscriber_ = handle_.subscribe<Gap>(component + "/gap", kSampleQueueSize, gap_callback);
  }
}

template <class Sample, class Measured, class Answer>
void LogPlayer::open(const char* sample, const char* measured, const char* answer) {
  const std::string& component = options_.component;
  displacement_publisher_ = handle_.advertise<Sample>(component + sample, kSampleQueueSize);
  measured_force_publisher_ = handle_.advertise<Measured>(component + measured, kSampleQueueSize);
  const boost::function<void(const boost::shared_ptr<const Answer>&)> callback =
      [this](const boost::shared_ptr<const Answer>& message) { take(*message); };
  subscriber_ = handle_.subscribe<Answer>(component + answer, kSampleQueueSize, callback, ros::VoidConstPtr(),
                                          ros::TransportHints().tcpNoDelay());
}

bool LogPlayer::isConnected(double patience) {
  return waitForPublishers(subscriber_.getTopic(), patience) &&
         (!options_.record_gap || waitForPublishers(gap_subscriber_.getTopic(), patience)) &&
         waitFor(queue_, patience, [this] { return displacement_publisher_.getNumSubscribers() > 0; }) &&
         hearsMeasured(patience);
}

// Waits for subscribers of the measured force, so that they do not lose its first messages. A node need not subscribe.
bool LogPlayer::hearsMeasured(double patience) {
  constexpr double kUnasked = 2.0;  // [s]; the node subscribes to this topic right after the displacement
  const bool needed = options_.record_gap || options_.listeners > 0;
  const bool heard = waitFor(queue_, needed ? patience : std::min(patience, kUnasked),
                             [this] { return measured_force_publisher_.getNumSubscribers() > options_.listeners; });
  return heard || (!needed && ros::ok());
}

// Throws if a running node serves other components but not this one, because it would be useless to wait.
void LogPlayer::requireServed() const {
  std::vector<std::string> served = servedComponents(handle_.resolveName("forces"));
  if (served.empty() ||
      std::find(served.begin(), served.end(), handle_.resolveName(options_.component)) != served.end()) {
    return;
  }
  const std::string space = handle_.getNamespace() == "/" ? "/" : handle_.getNamespace() + "/";
  for (std::string& name : served) {
    name = name.compare(0, space.size(), space) == 0 ? name.substr(space.size()) : name;
  }
  throw PlayError(fmt::format("the running node does not serve the component '{}'{}; accepted: {}", options_.component,
                              element::didYouMean(options_.component, served), log::join(served)));
}

void LogPlayer::connect() {
  const auto begin = Steady::now();
  for (double waited = 0.0; !connected_; waited = seconds(Steady::now() - begin)) {
    if (waited >= options_.connect_timeout || !ros::ok()) {
      throw PlayError(fmt::format("no node serves {} within {:.3g} s", displacement_publisher_.getTopic(), waited));
    }
    if (waited >= kPatienceWithOthers) {  // until then, a further node with this component may start
      requireServed();
    }
    if (waited > 0.0) {
      options_.notify(fmt::format("waiting for the node that serves {} and for all its subscribers: {:.0f} of {:g} s",
                                  displacement_publisher_.getTopic(), waited, options_.connect_timeout));
    }
    connected_ = isConnected(std::min(options_.connect_timeout - waited, kNoteEvery));
  }
}

template <class Answer>
void LogPlayer::take(const Answer& answer) {
  last_answer_ = Steady::now();
  if (log_ == nullptr) {
    return;
  }
  const std::int64_t stamp = static_cast<std::int64_t>(answer.header.stamp.toNSec()) - shift_;
  const auto end = log_->stamp.begin() + static_cast<std::ptrdiff_t>(result_.sent);
  const auto found = std::lower_bound(log_->stamp.begin(), end, stamp);
  if (found == end || *found != stamp) {
    ++result_.unexpected;
    return;
  }
  const auto sample = static_cast<std::size_t>(found - log_->stamp.begin());
  const std::array<double, 6> numbers = numbersOf(answer);
  const bool finite = std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
  if (!finite && !not_finite_) {
    not_finite_ = sample;
  }
  if (++result_.answers[sample] > 1) {
    return;
  }
  ++answered_;
  if (poses_ == nullptr) {
    result_.force[sample] = {numbers[0], numbers[1], numbers[2], numbers[3]};
  }
  for (std::size_t i = 0; poses_ != nullptr && i < numbers.size(); ++i) {
    result_.wrench[i][sample] = numbers[i];
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
  const PlayControl* const control = options_.control;
  const bool held = control != nullptr && !control->running() && stepped_ >= control->granted();
  return result_.sent < log_->size() && result_.sent - answered_ < options_.in_flight && !held;
}

// Sends temperatures well before the samples to which they apply, because messages of two topics may arrive in any
// order. Their number is limited to what the node stores.
void LogPlayer::announceTemperatures() {
  constexpr std::size_t kAhead = 512;
  const auto next = std::lower_bound(temperature_changes_.begin(), temperature_changes_.end(), result_.sent);
  const auto last = static_cast<std::size_t>(next - temperature_changes_.begin()) + kAhead;
  for (; announced_ < std::min(last, temperature_changes_.size()); ++announced_) {
    const std::size_t sample = temperature_changes_[announced_];
    sensor_msgs::Temperature temperature;
    temperature.header.stamp = bag::toRosTime(log_->stamp[sample] + shift_);
    temperature.temperature = log_->temperature[sample];
    temperature_publisher_.publish(temperature);
  }
}

// Sends the first temperatures and waits, because they must arrive before the first sample.
void LogPlayer::startTemperatures() {
  constexpr double kPatience = 5.0;  // [s]
  constexpr double kArrival = 0.2;   // [s], many times the transfer time of a message
  temperature_changes_.clear();
  announced_ = 0;
  for (std::size_t i = 0; i < log_->temperature.size(); ++i) {
    if (i == 0 || log_->temperature[i] != log_->temperature[i - 1]) {
      temperature_changes_.push_back(i);
    }
  }
  if (temperature_changes_.empty()) {
    return;
  }
  waitFor(queue_, kPatience, [this] { return temperature_publisher_.getNumSubscribers() > 0; });
  announceTemperatures();
  ros::WallDuration(kArrival).sleep();
}

void LogPlayer::send() {
  announceTemperatures();
  const std::size_t sample = result_.sent++;
  if (poses_ != nullptr) {
    sendPose(sample);
    return;
  }
  Displacement displacement;
  displacement.header.stamp = bag::toRosTime(log_->stamp[sample] + shift_);
  displacement.displacement = log_->displacement[sample];
  displacement_publisher_.publish(displacement);
  if (!log_->force.empty() && log::isCounted(*log_, sample)) {
    MeasuredForce force;
    force.header.stamp = displacement.header.stamp;
    force.force = log_->force[sample];
    measured_force_publisher_.publish(force);
  }
}

void LogPlayer::sendPose(std::size_t sample) {
  const auto vector = [sample](const auto& lists, std::size_t first) {
    return Eigen::Vector3d(lists[first][sample], lists[first + 1][sample], lists[first + 2][sample]);
  };
  geometry_msgs::PoseStamped pose;
  pose.header.stamp = bag::toRosTime(log_->stamp[sample] + shift_);
  pose.pose = messageOf(vector(poses_->coordinate, 0), gap::rotationAt(*poses_, *options_.rotation, sample));
  displacement_publisher_.publish(pose);
  if (!poses_->wrench[0].empty() && (poses_->counts.empty() || poses_->counts[sample] > 0.0)) {
    geometry_msgs::WrenchStamped measured;
    measured.header = pose.header;
    measured.wrench = messageOf(component::Wrench{vector(poses_->wrench, 0), vector(poses_->wrench, 3)});
    measured_force_publisher_.publish(measured);
  }
}

// Sends all samples that are due. During a pause time stands still, so that the next sample is due when the pause ends.
void LogPlayer::sendWhatIsDue(io::Progress& progress) {
  const bool stepping = options_.control != nullptr && !options_.control->running();
  if (stepping && result_.sent < log_->size()) {
    start_ += toDuration(-untilDue());
  }
  while (maySend() && untilDue() <= 0.0) {
    stepped_ += stepping ? 1 : 0;
    send();
    progress.advance();
  }
}

// Receives answers until the next sample is due. Returns false after `answer_timeout` without an answer.
bool LogPlayer::waitForAnswers() {
  constexpr double kLongestWait = 0.05;  // time until shutdown and control are checked again [s]
  const bool waits_for_answer = result_.sent > answered_;
  queue_.callAvailable(ros::WallDuration(maySend() ? std::clamp(untilDue(), 0.0, kLongestWait) : kLongestWait));
  const auto now = Steady::now();
  if (!waits_for_answer) {
    last_answer_ = now;
  }
  const double waited = seconds(now - last_answer_);
  if (waited > kNoteEvery && seconds(now - last_note_) > kNoteEvery) {
    last_note_ = now;
    options_.notify(fmt::format("waiting for an answer on {}: {:.0f} of {:g} s", subscriber_.getTopic(), waited,
                                options_.answer_timeout));
  }
  return waited <= options_.answer_timeout;
}

// Waits for surplus answers, which would come at once, and for a gap that includes the last sample.
void LogPlayer::waitForLast() {
  constexpr double kLinger = 0.2;     // [s], many times a round trip
  constexpr double kPatience = 10.0;  // [s]
  waitFor(queue_, kLinger, [] { return false; });
  if (options_.record_gap && !log_->force.empty()) {
    waitFor(queue_, kPatience,
            [this] { return !result_.gap_stamps.empty() && result_.gap_stamps.back() >= log_->stamp.back(); });
  }
}

PlayResult LogPlayer::play(const log::Log& log, Steady::time_point start, bool more_follow, const log::PoseLog* poses) {
  log::checkLog(log);
  connect();
  log_ = &log;
  poses_ = poses;
  shift_ = goes_on_ ? shift_ : bag::headerShift(log);
  goes_on_ = more_follow;
  result_ = PlayResult();
  not_finite_.reset();
  result_.shift = shift_;
  result_.force.resize(log.size());
  for (auto& list : result_.wrench) {
    list.resize(poses == nullptr ? 0 : log.size());
  }
  result_.answers.resize(log.size());
  answered_ = 0;
  startTemperatures();
  io::Progress progress("playing " + log.name, options_.show_progress ? log.size() : 0);
  const auto begin = Steady::now();
  start_ = start == Steady::time_point() ? begin : start;
  last_answer_ = begin;
  bool answers_come = true;
  while (ros::ok() && answers_come && answered_ < log.size()) {
    sendWhatIsDue(progress);
    answers_come = waitForAnswers();
    if (not_finite_) {
      throw PlayError(fmt::format("{}: the answer at {} s is not finite; accepted: a number for each displacement",
                                  subscriber_.getTopic(), log::formatStamp(log.stamp[*not_finite_])));
    }
  }
  result_.duration = seconds(last_answer_ - begin);
  if (!more_follow && answers_come) {
    waitForLast();
  }
  log_ = nullptr;
  return std::move(result_);
}

}  // namespace rubber_suspension::ros_interface
