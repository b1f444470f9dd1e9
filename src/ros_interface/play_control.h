// Pauses, steps and resumes a playback, by means of the services ~pause and ~step or of function calls.
#pragma once

#include <fmt/format.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cstddef>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Control that the players of all components share. Thread-safe.
class PlayControl {
 public:
  /// `step`, at least 1, is the number of samples that each component plays per step.
  PlayControl(std::size_t step, bool paused) : step_(step), running_(!paused) {}

  bool running() const { return running_; }

  /// Returns the total number of samples, since the start, that each component may play by steps.
  std::size_t granted() const { return granted_; }

  void pause(bool paused) { running_ = !paused; }

  /// Plays `step` more samples of each component, then pauses.
  void step() {
    running_ = false;
    granted_ += step_;
  }

 private:
  const std::size_t step_;
  std::atomic<bool> running_;
  std::atomic<std::size_t> granted_{0};
};

/// The services ~pause (std_srvs/SetBool; true: pause) and ~step (std_srvs/Trigger), in a thread of their own.
class PlayControlServices {
 public:
  PlayControlServices(const ros::NodeHandle& private_handle, PlayControl& control)
      : handle_(private_handle), spinner_(1, &queue_) {
    using std_srvs::SetBool;
    using std_srvs::Trigger;
    handle_.setCallbackQueue(&queue_);
    const auto pause = [&control](SetBool::Request& request, SetBool::Response& response) {
      control.pause(request.data != 0U);
      response.success = 1U;
      response.message = request.data != 0U ? "paused" : "running";
      return true;
    };
    const auto step = [&control](Trigger::Request& /*request*/, Trigger::Response& response) {
      control.step();
      response.success = 1U;
      response.message = fmt::format("{} samples of each component have been released so far", control.granted());
      return true;
    };
    servers_ = {handle_.advertiseService<SetBool::Request, SetBool::Response>("pause", pause),
                handle_.advertiseService<Trigger::Request, Trigger::Response>("step", step)};
    spinner_.start();
  }

 private:
  ros::NodeHandle handle_;
  ros::CallbackQueue queue_;
  std::vector<ros::ServiceServer> servers_;
  ros::AsyncSpinner spinner_;
};

}  // namespace rubber_suspension::ros_interface
