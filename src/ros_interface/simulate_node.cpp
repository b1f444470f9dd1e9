// The node, put together.
#include "ros_interface/simulate_node.h"

#include <ros/console.h>
#include <unistd.h>

#include <algorithm>

#include "ros_interface/loopback.h"

namespace rubber_suspension::ros_interface {

SimulateNode::SimulateNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : handle_(handle), private_handle_(private_handle), settings_(readNodeSettings(private_handle_)) {
  makeChannels();
  keepToLoopback();
  setUpRealTime();
  startServing();
  advertiseServices();
}

SimulateNode::~SimulateNode() {
  for (auto& server : servers_) {
    server->shutdown();
  }
  bundle_->shutdown();
  for (auto& thread : threads_) {
    thread->stop();
  }
}

void SimulateNode::makeChannels() {
  for (const io::ComponentDescription& description : readComponents(private_handle_)) {
    channels_.push_back(std::make_unique<node::ComponentChannel>(description, settings_.max_gap));
  }
  if (settings_.load_state && access(settings_.state_file.c_str(), F_OK) == 0) {
    loadStates(settings_.state_file, channels());
    ROS_INFO("going on from %s", settings_.state_file.c_str());
  }
}

void SimulateNode::keepToLoopback() {
  const std::string refusal = keepSlaveApiToLoopback();
  if (!refusal.empty()) {
    ROS_WARN("%s", refusal.c_str());
  }
}

void SimulateNode::setUpRealTime() {
  if (settings_.lock_memory) {
    const std::string refusal = lockMemory();
    if (refusal.empty()) {
      ROS_INFO("memory locked");
    } else {
      ROS_WARN("%s", refusal.c_str());
    }
  }
}

void SimulateNode::startServing() {
  const std::size_t count = std::min<std::size_t>(static_cast<std::size_t>(settings_.threads), channels_.size());
  for (std::size_t i = 0; i < count; ++i) {
    threads_.push_back(std::make_unique<ServingThread>());
  }
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    ros::NodeHandle group(handle_);
    group.setCallbackQueue(&threads_[i % count]->queue());
    servers_.push_back(std::make_unique<SampleServer>(group, *channels_[i], settings_.queue_size));
  }
  ros::NodeHandle first_group(handle_);
  first_group.setCallbackQueue(&threads_.front()->queue());
  bundle_ = std::make_unique<BundleServer>(first_group, channels(), settings_.queue_size);
  startThreads();
}

void SimulateNode::startThreads() {
  std::string refusal;
  for (auto& thread : threads_) {
    refusal = thread->start(settings_.realtime_priority);
  }
  if (!refusal.empty()) {
    ROS_WARN("%s; serving at normal priority", refusal.c_str());
  } else if (settings_.realtime_priority > 0) {
    ROS_INFO("serving at SCHED_FIFO priority %d", settings_.realtime_priority);
  }
}

void SimulateNode::advertiseServices() {
  diagnostics_ = std::make_unique<NodeDiagnostics>(handle_, private_handle_, channels(), settings_.gap);
  diagnostics_->watch(*bundle_);
  services_ = std::make_unique<NodeServices>(handle_, private_handle_, settings_, channels());
  registration_ = std::make_unique<RegistrationKeeper>(private_handle_, services_->names());
}

std::vector<node::ComponentChannel*> SimulateNode::channels() const {
  std::vector<node::ComponentChannel*> pointers;
  for (const auto& channel : channels_) {
    pointers.push_back(channel.get());
  }
  return pointers;
}

}  // namespace rubber_suspension::ros_interface
