// The node, put together.
#include "rubber_suspension/ros_interface/simulate_node.h"

#include <fmt/format.h>
#include <ros/console.h>

namespace rubber_suspension {

SimulateNode::SimulateNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : handle_(handle), private_handle_(private_handle), settings_(readNodeSettings(private_handle_)) {
  makeChannels();
  setUpRealTime();
  startServing();
  advertiseServices();
}

SimulateNode::~SimulateNode() {
  for (auto& server : servers_) {
    server->shutdown();
  }
  for (auto& thread : threads_) {
    thread->stop();
  }
}

void SimulateNode::makeChannels() {
  for (const ComponentDescription& description : readComponents(private_handle_)) {
    channels_.push_back(std::make_unique<ComponentChannel>(description, settings_.max_gap));
  }
}

void SimulateNode::setUpRealTime() {
  if (settings_.lock_memory) {
    const std::string refusal = lockMemory();
    ROS_INFO("%s", refusal.empty() ? "memory locked" : refusal.c_str());
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
  for (auto& thread : threads_) {
    const std::string refusal = thread->start(settings_.realtime_priority);
    if (!refusal.empty()) {
      ROS_WARN("%s; serving at normal priority", refusal.c_str());
    }
  }
}

void SimulateNode::advertiseServices() {
  std::vector<ComponentChannel*> channels;
  for (auto& channel : channels_) {
    channels.push_back(channel.get());
  }
  diagnostics_ = std::make_unique<NodeDiagnostics>(handle_, private_handle_, channels);
  services_.push_back(private_handle_.advertiseService("reset", &SimulateNode::reset, this));
}

bool SimulateNode::reset(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  for (auto& channel : channels_) {
    channel->reset();
  }
  response.success = true;
  response.message = fmt::format("{} components are new specimens at rest", channels_.size());
  return true;
}

}  // namespace rubber_suspension
