// Checks that a topic is connected.
#include "ros_interface/connection.h"

#include <fmt/format.h>
#include <ros/init.h>
#include <ros/service.h>
#include <ros/this_node.h>
#include <std_srvs/Trigger.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <chrono>

#include "ros_interface/master.h"

namespace rubber_suspension::ros_interface {
namespace {

using XmlRpc::XmlRpcValue;

constexpr double kAnswerLimit = 5.0;  // [s]

// Returns the value in the answer to a call. Throws XmlRpcException if no answer comes.
XmlRpcValue ask(const std::string& uri, const std::string& method, const std::vector<std::string>& arguments = {}) {
  const auto answer = call(kAnswerLimit, uri, method, callArguments(arguments));
  if (!answer) {
    throw XmlRpc::XmlRpcException("no answer to the call " + method);
  }
  return (*answer)[2];
}

// Returns all advertised topics with their publishers, or an empty map if the master does not answer.
Registered publishedTopics() {
  const auto names = registeredNames(kAnswerLimit);
  return names ? names->front() : Registered();
}

}  // namespace

bool waitFor(ros::CallbackQueue& queue, double timeout, const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout);
  while (!condition()) {
    if (!ros::ok() || std::chrono::steady_clock::now() > end) {
      return false;
    }
    queue.callAvailable(ros::WallDuration(0.02));
  }
  return true;
}

std::string callTrigger(const std::string& resolved_service, double timeout) {
  ros::CallbackQueue nothing;
  std_srvs::Trigger trigger;
  waitFor(nothing, timeout, [&] { return ros::service::exists(resolved_service, false); });
  const bool done = callService(resolved_service, trigger) && trigger.response.success != 0U;
  return done ? "" : fmt::format("service {} failed: {}", resolved_service, trigger.response.message);
}

std::vector<std::string> servedComponents(const std::string& bundle_topic) {
  const std::string ending = "/force";
  const auto topics = publishedTopics();
  const auto bundle = topics.find(bundle_topic);
  std::vector<std::string> components;
  for (const auto& [name, publishers] : topics) {
    const bool served =
        bundle != topics.end() && std::find_first_of(publishers.begin(), publishers.end(), bundle->second.begin(),
                                                     bundle->second.end()) != publishers.end();
    const std::size_t length = name.size() - std::min(name.size(), ending.size());
    if (served && name.substr(length) == ending) {
      components.push_back(name.substr(0, length));
    }
  }
  return components;
}

bool sendsToThisNode(const std::string& publisher, const std::string& resolved_topic) {
  bool sends = false;
  try {
    const XmlRpcValue links = ask(ask(ros::master::getURI(), "lookupNode", {publisher}), "getBusInfo");
    for (int i = 0; i < links.size(); ++i) {  // rows of connection, other end, direction, transport, topic, ...
      const std::string& other_end = links[i][1];
      const std::string& direction = links[i][2];
      const std::string& topic = links[i][4];
      sends = sends || (other_end == ros::this_node::getName() && direction == "o" && topic == resolved_topic);
    }
  } catch (const XmlRpc::XmlRpcException&) {
    sends = false;
  }
  return sends;
}

bool waitForPublishers(const std::string& resolved_topic, double timeout) {
  ros::CallbackQueue nothing;
  return waitFor(nothing, timeout, [&] {
    const std::vector<std::string> publishers = publishedTopics()[resolved_topic];
    return !publishers.empty() && std::all_of(publishers.begin(), publishers.end(), [&](const std::string& publisher) {
      return sendsToThisNode(publisher, resolved_topic);
    });
  });
}

}  // namespace rubber_suspension::ros_interface
