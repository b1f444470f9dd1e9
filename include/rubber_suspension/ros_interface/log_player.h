// Plays a log through a running node and collects the forces: at a rate, or as fast as the node answers.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/Force.h>
#include <rubber_suspension/MeasuredForce.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include "rubber_suspension/element/element.h"
#include "rubber_suspension/io/log.h"

namespace rubber_suspension {

struct PlayOptions {
  std::string component;
  double rate = 0.0;              ///< multiple of the log's own speed; 0: as fast as answers come
  std::size_t in_flight = 100;    ///< samples sent and not yet answered, at most
  double connect_timeout = 30.0;  ///< to wait for the node [s]
  double answer_timeout = 10.0;   ///< to wait for an answer [s]
};

/// What came back. The vectors have one entry per sample of the log.
struct PlayResult {
  std::vector<ComponentForce> force;   ///< the first answer to each sample
  std::vector<std::uint32_t> answers;  ///< how many forces each sample had
  std::size_t sent = 0;
  std::size_t unexpected = 0;  ///< forces whose stamp is that of no sample sent
  double duration = 0.0;       ///< from the first sample to the last answer [s]

  std::size_t answered() const;  ///< samples with at least one force
  bool exactlyOneEach() const;   ///< every sample of the log had one force, and none came besides
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

  /// Wait for the node; throws PlayError. play() does it too.
  void connect();

  /// Play a log that checkLog accepts. Samples that stay without answer are in the result. Throws PlayError.
  PlayResult play(const Log& log);

 private:
  using Steady = std::chrono::steady_clock;

  void take(const Force& force);
  bool maySend() const;
  void send();
  double untilDue() const;
  void lingerForSurplus();

  PlayOptions options_;
  ros::NodeHandle handle_;
  ros::CallbackQueue queue_;
  ros::Publisher displacement_publisher_;
  ros::Publisher measured_force_publisher_;
  ros::Subscriber subscriber_;

  const Log* log_ = nullptr;
  std::int64_t shift_ = 0;
  PlayResult result_;
  std::size_t answered_ = 0;
  Steady::time_point start_;
  Steady::time_point last_answer_;
};

}  // namespace rubber_suspension
