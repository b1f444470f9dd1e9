// Whether a topic is connected for certain.
#include "ros_interface/connection.h"

#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <algorithm>
#include <chrono>

namespace rubber_suspension::ros_interface {
namespace {

using XmlRpc::XmlRpcValue;

bool isArray(const XmlRpcValue& value, int size) {
  return value.getType() == XmlRpcValue::TypeArray && value.size() >= size;
}

bool isText(const XmlRpcValue& value, const std::string& text) {
  return value.getType() == XmlRpcValue::TypeString && static_cast<const std::string&>(value) == text;
}

XmlRpcValue callerId() {
  XmlRpcValue arguments;
  arguments[0] = ros::this_node::getName();
  return arguments;
}

// The address of a node's slave API; false where the master does not know it.
bool findNode(const std::string& node, std::string& host, std::uint32_t& port) {
  XmlRpcValue arguments = callerId();
  arguments[1] = node;
  XmlRpcValue response;
  XmlRpcValue uri;
  return ros::master::execute("lookupNode", arguments, response, uri, false) &&
         uri.getType() == XmlRpcValue::TypeString && ros::network::splitURI(static_cast<std::string&>(uri), host, port);
}

struct PublishedTopic {
  std::string name;
  std::vector<std::string> publishers;
};

// All topics that are advertised; none where the master does not answer.
std::vector<PublishedTopic> publishedTopics() {
  XmlRpcValue response;
  XmlRpcValue state;
  std::vector<PublishedTopic> topics;
  if (!ros::master::execute("getSystemState", callerId(), response, state, false) || !isArray(state, 1) ||
      !isArray(state[0], 0)) {
    return topics;
  }
  for (int i = 0; i < state[0].size(); ++i) {
    const XmlRpcValue& row = state[0][i];
    if (isArray(row, 2) && row[0].getType() == XmlRpcValue::TypeString && isArray(row[1], 0)) {
      topics.push_back({static_cast<const std::string&>(row[0]), {}});
      for (int j = 0; j < row[1].size(); ++j) {
        topics.back().publishers.push_back(static_cast<const std::string&>(row[1][j]));
      }
    }
  }
  return topics;
}

// A row of getBusInfo: connection, other end, direction, transport, topic, ...
bool isLinkToThisNode(const XmlRpcValue& row, const std::string& topic) {
  return isArray(row, 5) && isText(row[1], ros::this_node::getName()) && isText(row[2], "o") && isText(row[4], topic);
}

}  // namespace

std::vector<std::string> publishersOf(const std::string& resolved_topic) {
  for (const PublishedTopic& topic : publishedTopics()) {
    if (topic.name == resolved_topic) {
      return topic.publishers;
    }
  }
  return {};
}

std::vector<std::string> servedComponents(const std::string& bundle_topic) {
  const std::vector<PublishedTopic> topics = publishedTopics();
  const auto bundle = std::find_if(topics.begin(), topics.end(),
                                   [&](const PublishedTopic& topic) { return topic.name == bundle_topic; });
  std::vector<std::string> components;
  if (bundle == topics.end()) {
    return components;
  }
  const std::string ending = "/force";
  for (const PublishedTopic& topic : topics) {
    const bool served = std::any_of(topic.publishers.begin(), topic.publishers.end(), [&](const std::string& node) {
      return std::find(bundle->publishers.begin(), bundle->publishers.end(), node) != bundle->publishers.end();
    });
    const std::size_t length = topic.name.size() - std::min(topic.name.size(), ending.size());
    if (served && topic.name.substr(length) == ending) {
      components.push_back(topic.name.substr(0, length));
    }
  }
  return components;
}

bool sendsToThisNode(const std::string& publisher, const std::string& resolved_topic) {
  std::string host;
  std::uint32_t port = 0;
  if (!findNode(publisher, host, port)) {
    return false;
  }
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpcValue answer;
  const bool answered = client.execute("getBusInfo", callerId(), answer);
  client.close();
  if (!answered || !isArray(answer, 3) || !isArray(answer[2], 0)) {
    return false;
  }
  for (int i = 0; i < answer[2].size(); ++i) {
    if (isLinkToThisNode(answer[2][i], resolved_topic)) {
      return true;
    }
  }
  return false;
}

bool waitForPublishers(const std::string& resolved_topic, double timeout) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout);
  while (ros::ok()) {
    const std::vector<std::string> publishers = publishersOf(resolved_topic);
    const bool connected = std::all_of(publishers.begin(), publishers.end(), [&](const std::string& publisher) {
      return sendsToThisNode(publisher, resolved_topic);
    });
    if (!publishers.empty() && connected) {
      return true;
    }
    if (std::chrono::steady_clock::now() >= end) {
      return false;
    }
    ros::WallDuration(0.02).sleep();
  }
  return false;
}

}  // namespace rubber_suspension::ros_interface
