// Plays a log through a running node and collects the forces: at a rate, or as fast as the node answers.
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
  double rate = 0.0;               ///< multiple of the log's own speed; 0: as fast as answers come
  std::size_t in_flight = 100;     ///< samples sent and not yet answered, at most
  std::size_t listeners = 0;       ///< nodes to wait for that listen to the measured force besides the one that serves
  double connect_timeout = 300.0;  ///< to wait for the node and the listeners [s]; a starved machine starts slowly
  double answer_timeout = 60.0;    ///< to wait for an answer [s]
  bool record_gap = false;         ///< collect the live gap, too
  std::optional<component::RotationMeasure> rotation;  ///< logs of poses are played, their rotation in this measure
  bool show_progress = true;                           ///< on a terminal
  PlayControl* control = nullptr;                      ///< holds and steps the playback; has to outlive the player
  std::function<void(const std::string&)> notify = [](const std::string&) {};  ///< told what is being waited for
};

/// The forces that came back. The vectors have one entry per sample of the log.
struct PlayResult {
  std::vector<element::ComponentForce> force;  ///< the first answer to each sample
  std::array<std::vector<double>, 6> wrench;   ///< the same of poses [N, N m]
  std::vector<std::uint32_t> answers;          ///< how many forces each sample had
  std::size_t sent = 0;
  std::int64_t shift = 0;                ///< from the log's stamps to those of the headers [ns]
  std::size_t unexpected = 0;            ///< forces whose stamp is that of no sample sent
  std::vector<GapConstPtr> gaps;         ///< the live gap, in the order of arrival
  std::vector<std::int64_t> gap_stamps;  ///< of them, as stamps of the log [ns]
  double duration = 0.0;                 ///< from the first sample to the last answer [s]

  std::size_t answered() const;        ///< samples with at least one force
  bool exactlyOneEach() const;         ///< every sample of the log had one force, and none came besides
  std::vector<double> totals() const;  ///< of the forces [N]
};

/// No node serves the component, or it stopped answering.
class PlayError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Sends and receives in the calling thread, with a callback queue of its own.
class LogPlayer {
 public:
  LogPlayer(const ros::NodeHandle& handle, const PlayOptions& options);

  using Steady = std::chrono::steady_clock;

  /// Wait for the node; throws PlayError, which lists the components of a node that serves others and not this one, as
  /// after a slip of the name. play() does it too.
  void connect();

  /// Play a log that checkLog accepts, its first sample at `start`, without one at once. Samples that stay without
  /// answer are in the result; it ends early where ROS is shut down. Unless more logs follow, wait for what may come
  /// after the last answer: a force too many, and the gap up to the last sample. Throws PlayError. Plays a log; for
  /// poses it has stamps and temperatures, and `poses` the rest.
  PlayResult play(const log::Log& log, Steady::time_point start = {}, bool more_follow = false,
                  const log::PoseLog* poses = nullptr);

  /// When the first sample of the last log was due; later by the time that the playback was held.
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
  bool goes_on_ = false;  // the last log is to be followed by another, in the same time

  const log::Log* log_ = nullptr;
  const log::PoseLog* poses_ = nullptr;
  std::int64_t shift_ = 0;
  PlayResult result_;
  std::optional<std::size_t> not_finite_;  // the first sample whose answer is not
  std::size_t answered_ = 0;
  std::size_t stepped_ = 0;                       // samples sent by step, in all plays
  std::vector<std::size_t> temperature_changes_;  // samples of the log from which on another one holds
  std::size_t announced_ = 0;                     // of these changes
  Steady::time_point start_;                      // when the first sample was due, or would have been without pauses
  Steady::time_point last_answer_;
  Steady::time_point last_note_;
};

}  // namespace rubber_suspension::ros_interface
