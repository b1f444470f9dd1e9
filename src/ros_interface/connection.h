// Checks that a topic is connected, so that the first message is not lost.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <functional>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Executes the callbacks of the queue until the condition is true. Returns false after `timeout` [s] or if ROS ends.
bool waitFor(ros::CallbackQueue& queue, double timeout, const std::function<bool()>& condition);

/// Calls a service by means of a persistent connection. ros::service::call() is not used: it closes its connection
/// after the answer, and reports a failure if the answer comes before it begins to wait.
template <class Service>
bool callService(const std::string& name, Service& service) {
  return ros::NodeHandle().serviceClient<Service>(name, true).call(service);
}

/// Waits at most `timeout` [s] for a service of type std_srvs/Trigger and calls it. Returns the reason of a failure.
std::string callTrigger(const std::string& resolved_service, double timeout);

/// Returns the resolved names of the components of those `simulate` nodes that answer bundles on this resolved topic
/// (`.../forces`). A node advertises the bundled topic after the topics of its components, so the list is complete.
std::vector<std::string> servedComponents(const std::string& bundle_topic);

/// Returns true if this publisher already sends to this process. It asks the publisher (slave API, getBusInfo), because
/// a subscriber also counts connections that are not established yet.
bool sendsToThisNode(const std::string& publisher, const std::string& resolved_topic);

/// Waits until the topic has publishers and all of them send to this node. Returns false after `timeout` [s].
bool waitForPublishers(const std::string& resolved_topic, double timeout);

}  // namespace rubber_suspension::ros_interface
