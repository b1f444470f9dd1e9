// Checks that a topic is connected, so that the first message is not lost.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <functional>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Call what comes to the queue until the condition holds. False where it does not within `timeout` [s], or ROS ends.
bool waitFor(ros::CallbackQueue& queue, double timeout, const std::function<bool()>& condition);

/// Call a service by a connection that stays open until the answer is there. Where ros::service::call() is given an
/// answer before it has begun to wait for it, it sees the connection closed and reports a failure.
template <class Service>
bool callService(const std::string& name, Service& service) {
  return ros::NodeHandle().serviceClient<Service>(name, true).call(service);
}

/// Call a service of type std_srvs/Trigger, once it is there. Returns why it failed, or was not there within `timeout`
/// [s], or nothing.
std::string callTrigger(const std::string& resolved_service, double timeout);

/// The components, by their resolved names, of the nodes `simulate` that answer bundles on this resolved topic
/// (`.../forces`). A node advertises that topic after those of its components, so the list is complete. Empty where no
/// such node is running yet.
std::vector<std::string> servedComponents(const std::string& bundle_topic);

/// True if this publisher already sends to this process: asked of the publisher itself (slave API, getBusInfo), because
/// what the subscriber's side counts are connections that may still be in the making.
bool sendsToThisNode(const std::string& publisher, const std::string& resolved_topic);

/// Wait until the topic has a publisher and every one of them sends to this node. False after `timeout` [s].
bool waitForPublishers(const std::string& resolved_topic, double timeout);

}  // namespace rubber_suspension::ros_interface
