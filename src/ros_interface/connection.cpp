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

// A row of getBusInfo: connection, other end, direction, transport, topic, ...
bool isLinkToThisNode(const XmlRpcValue& row, const std::string& topic) {
  return isArray(row, 5) && isText(row[1], ros::this_node::getName()) && isText(row[2], "o") && isText(row[4], topic);
}

}  // namespace

std::vector<std::string> publishersOf(const std::string& resolved_topic) {
  XmlRpcValue response;
  XmlRpcValue state;
  std::vector<std::string> publishers;
  if (!ros::master::execute("getSystemState", callerId(), response, state, false) || !isArray(state, 1) ||
      !isArray(state[0], 0)) {
    return publishers;
  }
  for (int i = 0; i < state[0].size(); ++i) {
    const XmlRpcValue& topic = state[0][i];
    if (isArray(topic, 2) && isText(topic[0], resolved_topic) && isArray(topic[1], 0)) {
      for (int j = 0; j < topic[1].size(); ++j) {
        publishers.push_back(static_cast<const std::string&>(topic[1][j]));
      }
    }
  }
  return publishers;
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
