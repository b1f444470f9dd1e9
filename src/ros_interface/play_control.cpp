// Holds, steps and resumes a playback from outside.
#include "ros_interface/play_control.h"

#include <fmt/format.h>

namespace rubber_suspension::ros_interface {

void PlayControl::step() {
  running_ = false;
  granted_ += step_;
}

PlayControlServices::PlayControlServices(const ros::NodeHandle& private_handle, PlayControl& control)
    : control_(control), handle_(private_handle), spinner_(1, &queue_) {
  handle_.setCallbackQueue(&queue_);
  pause_server_ = handle_.advertiseService("pause", &PlayControlServices::pause, this);
  step_server_ = handle_.advertiseService("step", &PlayControlServices::step, this);
  spinner_.start();
}

bool PlayControlServices::pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  control_.pause(request.data);
  response.success = true;
  response.message = request.data ? "paused" : "running";
  return true;
}

bool PlayControlServices::step(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  control_.step();
  response.success = true;
  response.message = fmt::format("{} samples of each component released so far", control_.granted());
  return true;
}

}  // namespace rubber_suspension::ros_interface
