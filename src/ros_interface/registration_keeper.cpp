// Registers the node anew when the master was restarted.
#include "ros_interface/registration_keeper.h"

#include <fmt/format.h>
#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcClient.h>

namespace rubber_suspension::ros_interface {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue request(const std::vector<std::string>& arguments) {
  XmlRpcValue value;
  value[0] = ros::this_node::getName();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    value[static_cast<int>(i) + 1] = arguments[i];
  }
  return value;
}

std::string ownUri() { return ros::XMLRPCManager::instance()->getServerURI(); }

bool call(const std::string& method, const std::vector<std::string>& arguments, XmlRpcValue& payload) {
  XmlRpcValue response;
  return ros::master::execute(method, request(arguments), response, payload, false);
}

// Ask or tell this process itself, as the master and other nodes do (slave API). Nothing where that fails.
XmlRpcValue askSelf(const std::string& method, const XmlRpcValue& arguments) {
  XmlRpcValue answer;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(ownUri(), host, port)) {
    return {};
  }
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  const bool answered = client.execute(method.c_str(), arguments, answer);
  client.close();
  return answered && answer.getType() == XmlRpcValue::TypeArray && answer.size() == 3 ? answer[2] : XmlRpcValue();
}

// Tell our own subscriptions who publishes, as the master does when a publisher registers after us.
void announcePublishers(const std::string& topic, const XmlRpcValue& publishers) {
  XmlRpcValue arguments = request({topic});
  arguments[2] = publishers;
  askSelf("publisherUpdate", arguments);
}

// Rows of [topic, type].
template <class Row>
void forEachTopic(const XmlRpcValue& topics, Row row) {
  if (topics.getType() != XmlRpcValue::TypeArray) {
    return;
  }
  for (int i = 0; i < topics.size(); ++i) {
    row(static_cast<const std::string&>(topics[i][0]), static_cast<const std::string&>(topics[i][1]));
  }
}

}  // namespace

Registration askMaster() {
  XmlRpcValue response;
  XmlRpcValue payload;
  if (ros::master::execute("lookupNode", request({ros::this_node::getName()}), response, payload, false)) {
    return Registration::known;
  }
  return response.getType() == XmlRpcValue::TypeArray ? Registration::unknown : Registration::no_answer;
}

void registerAnew(const std::vector<std::string>& services) {
  XmlRpcValue payload;
  forEachTopic(askSelf("getPublications", request({})), [&](const std::string& topic, const std::string& type) {
    call("registerPublisher", {topic, type, ownUri()}, payload);
  });
  forEachTopic(askSelf("getSubscriptions", request({})), [&](const std::string& topic, const std::string& type) {
    XmlRpcValue publishers;
    if (call("registerSubscriber", {topic, type, ownUri()}, publishers) && publishers.size() > 0) {
      announcePublishers(topic, publishers);
    }
  });
  const std::string service_uri =
      fmt::format("rosrpc://{}:{}", ros::network::getHost(), ros::ConnectionManager::instance()->getTCPPort());
  for (const std::string& service : services) {
    call("registerService", {service, service_uri, ownUri()}, payload);
  }
}

RegistrationKeeper::RegistrationKeeper(ros::NodeHandle& handle, const std::vector<std::string>& services)
    : services_(services) {
  timer_ = handle.createWallTimer(ros::WallDuration(2.0), [this](const ros::WallTimerEvent&) { check(); });
}

void RegistrationKeeper::check() {
  const Registration registration = askMaster();
  if (registration == Registration::no_answer && !lost_) {
    ROS_WARN("the master does not answer; samples are served on, over the connections that are there");
  }
  if (registration == Registration::unknown) {
    registerAnew(services_);
    ROS_WARN("the master does not know this node any more; registered anew");
  }
  lost_ = registration == Registration::no_answer;
}

}  // namespace rubber_suspension::ros_interface
