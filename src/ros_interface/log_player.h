// Plays a log through a running node, at a given rate or as fast as the node answers, and collects the forces.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/Force.h>
#include <rubber_suspension/Gap.h>
#include <rubber_suspension/MeasuredForce.h>

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/progress.h"
#include "ros_interface/play_control.h"
#include "rubber_suspension/component/rotation_measure.h"
#include "rubber_suspension/element/element.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::ros_interface {

struct PlayOptions {
  std::string component;
  double rate = 0.0;            ///< multiple of the original speed; 0: as fast as answers come
  std::size_t in_flight = 100;  ///< largest number of samples that are sent but not yet answered
  std::size_t listeners = 0;    ///< number of subscribers of the measured force to wait for, besides the serving node
  double connect_timeout = 300.0;  ///< longest wait for node and listeners [s]; nodes start slowly on a busy computer
  double answer_timeout = 60.0;    ///< longest wait for an answer [s]
  bool record_gap = false;         ///< whether to collect the live gap
  std::optional<component::RotationMeasure> rotation;  ///< for logs of poses; nullopt for displacements
  bool show_progress = true;                           ///< whether to show the progress on a terminal
  PlayControl* control = nullptr;                      ///< pauses and steps the playback; must outlive the player
  std::function<void(const std::string&)> notify = [](const std::string&) {};  ///< receives messages while waiting
};

/// The received forces. `force`, `wrench` and `answers` have one entry per sample of the log.
struct PlayResult {
  std::vector<element::ComponentForce> force;  ///< the first answer to each sample
  std::array<std::vector<double>, 6> wrench;   ///< the first answer to each pose [N, N m]
  std::vector<std::uint32_t> answers;          ///< number of answers to each sample
  std::size_t sent = 0;
  std::int64_t shift = 0;                ///< stamps of the headers minus stamps of the log [ns]
  std::size_t unexpected = 0;            ///< number of forces whose stamp no sent sample has
  std::vector<GapConstPtr> gaps;         ///< the live gap, in the order of arrival
  std::vector<std::int64_t> gap_stamps;  ///< stamps of `gaps` in the time of the log [ns]
  double duration = 0.0;                 ///< from the first sample to the last answer [s]

  std::size_t answered() const;        ///< returns the number of samples with at least one force
  bool exactlyOneEach() const;         ///< returns true if every sample has one force and no force was unexpected
  std::vector<double> totals() const;  ///< returns the total force of each sample [N]
};

/// Thrown if no node serves the component or the node stops answering.
class PlayError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Sends and receives in the calling thread, with a callback queue of its own.
class LogPlayer {
 public:
  LogPlayer(const ros::NodeHandle& handle, const PlayOptions& options);

  using Steady = std::chrono::steady_clock;

  /// Waits for the node; play() also calls this. Throws PlayError, also if a running node serves only other components.
  void connect();

  /// Plays a log that checkLog() accepts. The first sample is due at `start` (default: now). With `poses`, the log only
  /// provides stamps and temperatures. The playback ends early if ROS is shut down or answers fail to come; then the
  /// result contains samples without an answer. Unless more logs follow, waits for surplus forces and for the gap that
  /// includes the last sample. Throws PlayError.
  PlayResult play(const log::Log& log, Steady::time_point start = {}, bool more_follow = false,
                  const log::PoseLog* poses = nullptr);

  /// Returns the time at which the first sample of the last log was due, plus the duration of all pauses.
  Steady::time_point start() const { return start_; }

 private:
  template <class Answer>
  void take(const Answer& answer);
  template <class Sample, class Measured, class Answer>
  void open(const char* sample, const char* measured, const char* answer);
  void sendPose(std::size_t sample);
  bool isConnected(double patience);
  bool hearsMeasured(double patience);
  void requireServed() const;
  bool maySend() const;
  void send();
  void announceTemperatures();
  void startTemperatures();
  void sendWhatIsDue(io::Progress& progress);
  bool waitForAnswers();
  double untilDue() const;
  void waitForLast();

  PlayOptions options_;
  ros::NodeHandle handle_;
  ros::CallbackQueue queue_;
  ros::Publisher displacement_publisher_;
  ros::Publisher measured_force_publisher_;
  ros::Publisher temperature_publisher_;
  ros::Subscriber subscriber_;
  ros::Subscriber gap_subscriber_;
  bool connected_ = false;
  bool goes_on_ = false;  // true if another log follows, whose stamps continue those of this log

  const log::Log* log_ = nullptr;
  const log::PoseLog* poses_ = nullptr;
  std::int64_t shift_ = 0;
  PlayResult result_;
  std::optional<std::size_t> not_finite_;  // index of the first sample whose answer is not finite
  std::size_t answered_ = 0;
  std::size_t stepped_ = 0;                       // number of samples sent by steps in all calls of play()
  std::vector<std::size_t> temperature_changes_;  // indices of the samples at which the temperature changes
  std::size_t announced_ = 0;                     // number of these changes that were sent
  Steady::time_point start_;                      // see start()
  Steady::time_point last_answer_;
  Steady::time_point last_note_;
};

}  // namespace rubber_suspension::ros_interface
