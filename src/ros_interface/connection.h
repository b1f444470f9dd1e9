// Checks that a topic is connected, so that the first message is not lost.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <functional>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Executes the callbacks of the queue until the condition is true. Returns false after `timeout` [s], or if ROS ends.
bool waitFor(ros::CallbackQueue& queue, double timeout, const std::function<bool()>& condition);

/// Calls a service by a persistent connection. ros::service::call() closes its connection after the answer, and reports
/// a failure if the answer comes before it waits for it.
template <class Service>
bool callService(const std::string& name, Service& service) {
  return ros::NodeHandle().serviceClient<Service>(name, true).call(service);
}

/// Calls a service of type std_srvs/Trigger, for which it waits at most `timeout` [s]. Returns why that failed, or an
/// empty text.
std::string callTrigger(const std::string& resolved_service, double timeout);

/// Returns the resolved names of the components of the nodes `simulate` that answer bundles on this resolved topic
/// (`.../forces`); empty if there is no such node. A node advertises that topic after those of its components, so the
/// list is complete.
std::vector<std::string> servedComponents(const std::string& bundle_topic);

/// Returns true if this publisher already sends to this process. Asks the publisher (slave API, getBusInfo), because
/// the subscriber also counts connections that are not established yet.
bool sendsToThisNode(const std::string& publisher, const std::string& resolved_topic);

/// Waits until the topic has publishers and all of them send to this node. Returns false after `timeout` [s].
bool waitForPublishers(const std::string& resolved_topic, double timeout);

}  // namespace rubber_suspension::ros_interface
