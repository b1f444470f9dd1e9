// Holds, steps and resumes a playback from outside: by the services ~pause and ~step, or by calls.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cstddef>

namespace rubber_suspension::ros_interface {

/// Shared by the players of all components; all calls are safe from any thread.
class PlayControl {
 public:
  /// `step`: samples that each component plays per step, at least 1.
  PlayControl(std::size_t step, bool paused) : step_(step), running_(!paused) {}

  bool running() const { return running_; }

  /// Samples that each component may play while it does not run, counted from the start.
  std::size_t granted() const { return granted_; }

  void pause(bool paused) { running_ = !paused; }

  /// Play `step` more samples of each component, then hold.
  void step();

 private:
  const std::size_t step_;
  std::atomic<bool> running_;
  std::atomic<std::size_t> granted_{0};
};

/// The services ~pause (std_srvs/SetBool; true holds) and ~step (std_srvs/Trigger), in a thread of their own.
class PlayControlServices {
 public:
  PlayControlServices(const ros::NodeHandle& private_handle, PlayControl& control);

 private:
  bool pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool step(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  PlayControl& control_;
  ros::NodeHandle handle_;
  ros::CallbackQueue queue_;
  ros::ServiceServer pause_server_;
  ros::ServiceServer step_server_;
  ros::AsyncSpinner spinner_;
};

}  // namespace rubber_suspension::ros_interface
