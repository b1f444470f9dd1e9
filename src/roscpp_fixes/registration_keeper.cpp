// Registers the node again when the master was restarted.
#include "ros_interface/registration_keeper.h"

#include <fmt/format.h>
#include <pthread.h>
#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <chrono>

#include "ros_interface/termination.h"
#include "ros_interface/timed_call.h"

namespace rubber_suspension::ros_interface {
namespace {

using XmlRpc::XmlRpcValue;

constexpr std::chrono::seconds kPeriod(2);
constexpr double kLimit = 3.0;  // for one call [s]; a master with thousands of topics may be slow

std::string ownUri() { return ros::XMLRPCManager::instance()->getServerURI(); }

// Ask or tell this process itself, as the master and other nodes do (slave API). Nothing where that fails.
XmlRpcValue askSelf(const std::string& method, const XmlRpcValue& arguments, const std::atomic<bool>& stop) {
  std::string host;
  std::uint32_t port = 0;
  XmlRpcValue answer;
  const bool answered =
      ros::network::splitURI(ownUri(), host, port) && callWithin(kLimit, host, port, method, arguments, answer, stop);
  return answered && answer.getType() == XmlRpcValue::TypeArray && answer.size() == 3 ? answer[2] : XmlRpcValue();
}

// Rows of [topic, type], until one fails.
template <class Row>
bool forEachTopic(const XmlRpcValue& topics, Row row) {
  if (topics.getType() != XmlRpcValue::TypeArray) {
    return false;
  }
  for (int i = 0; i < topics.size(); ++i) {
    if (!row(static_cast<const std::string&>(topics[i][0]), static_cast<const std::string&>(topics[i][1]))) {
      return false;
    }
  }
  return true;
}

// Addresses of nodes; a master that answers anything else is not followed.
bool isListOfTexts(const XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeArray) {
    return false;
  }
  for (int i = 0; i < value.size(); ++i) {
    if (value[i].getType() != XmlRpcValue::TypeString) {
      return false;
    }
  }
  return true;
}

}  // namespace

RegistrationKeeper::RegistrationKeeper(std::vector<std::string> services)
    : services_(std::move(services)),
      service_uri_(
          fmt::format("rosrpc://{}:{}", ros::network::getHost(), ros::ConnectionManager::instance()->getTCPPort())),
      thread_([this] { run(); }) {}

RegistrationKeeper::~RegistrationKeeper() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  stopping_.notify_all();
  thread_.join();
}

void RegistrationKeeper::run() {
  pthread_setname_np(pthread_self(), "master");
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stopping_.wait_for(lock, kPeriod, [this] { return stop_.load(); })) {
    lock.unlock();
    check();
    lock.lock();
  }
}

RegistrationKeeper::Registration RegistrationKeeper::ask() {
  XmlRpcValue payload;
  switch (callMaster(kLimit, "lookupNode", callArguments({ros::this_node::getName()}), payload, stop_)) {
    case CallResult::done:
      return Registration::known;
    case CallResult::refused:
      return Registration::unknown;
    default:
      return Registration::no_answer;
  }
}

// Register a publisher, subscriber or service. What comes to the master while this node leaves it is taken back.
bool RegistrationKeeper::tell(const std::string& kind, const std::string& name, const std::string& detail,
                              const std::string& uri, XmlRpcValue& payload) {
  if (isEnding()) {
    return false;
  }
  const bool done =
      callMaster(kLimit, "register" + kind, callArguments({name, detail, uri}), payload, stop_) == CallResult::done;
  if (isEnding()) {
    XmlRpcValue ignored;
    callMaster(kLimit, "unregister" + kind, callArguments({name, kind == "Service" ? detail : uri}), ignored, stop_);
  }
  return done;
}

// And connect to the publishers that have registered before: tell our own subscriptions, as the master does when a
// publisher registers after us.
bool RegistrationKeeper::registerSubscriber(const std::string& topic, const std::string& type) {
  XmlRpcValue publishers;
  if (!tell("Subscriber", topic, type, ownUri(), publishers) || !isListOfTexts(publishers)) {
    return false;
  }
  if (publishers.size() > 0) {
    XmlRpcValue arguments = callArguments({topic});
    arguments[2] = publishers;
    askSelf("publisherUpdate", arguments, stop_);
  }
  return true;
}

// False where the master stopped answering; it is then asked again.
bool RegistrationKeeper::registerAnew() {
  XmlRpcValue payload;
  const auto publisher = [&](const std::string& topic, const std::string& type) {
    return tell("Publisher", topic, type, ownUri(), payload);
  };
  const auto subscriber = [this](const std::string& topic, const std::string& type) {
    return registerSubscriber(topic, type);
  };
  for (const std::string& service : services_) {
    if (!tell("Service", service, service_uri_, ownUri(), payload)) {
      return false;
    }
  }
  return forEachTopic(askSelf("getPublications", callArguments({}), stop_), publisher) &&
         forEachTopic(askSelf("getSubscriptions", callArguments({}), stop_), subscriber);
}

void RegistrationKeeper::check() {
  try {
    const Registration registration = ask();
    if (registration == Registration::no_answer && !lost_ && !stop_ && !isEnding()) {
      ROS_WARN("the master does not answer; samples are served on, over the connections that are there");
    }
    incomplete_ = incomplete_ || (registration == Registration::unknown && !isEnding());
    if (incomplete_ && registration != Registration::no_answer && registerAnew()) {
      incomplete_ = false;
      ROS_WARN("the master did not know this node any more; registered again");
    }
    lost_ = registration == Registration::no_answer;
  } catch (const XmlRpc::XmlRpcException& error) {
    ROS_WARN("the master answers what no master should: %s", error.getMessage().c_str());
  }
}

}  // namespace rubber_suspension::ros_interface
