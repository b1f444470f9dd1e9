// Registers the node again when the master was restarted.
#include "roscpp_fixes/registration_keeper.h"

#include <fmt/format.h>
#include <pthread.h>
#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <chrono>
#include <utility>

#include "roscpp_fixes/master_call.h"

namespace rubber_suspension::roscpp_fixes {
namespace {

using XmlRpc::XmlRpcValue;

constexpr std::chrono::seconds kPeriod(2);
constexpr double kLimit = 3.0;  // for one call [s]; a master with thousands of topics may be slow

std::string ownUri() { return ros::XMLRPCManager::instance()->getServerURI(); }

// Ask or tell this process itself, as the master and other nodes do (slave API). Nothing where that fails.
XmlRpcValue askSelf(const std::string& method, const XmlRpcValue& arguments, const std::atomic<bool>& stop) {
  std::string host;
  std::uint32_t port = 0;
  XmlRpcValue payload;
  return ros::network::splitURI(ownUri(), host, port) &&
                 callWithin(kLimit, host, port, method, arguments, payload, stop)
             ? payload
             : XmlRpcValue();
}

// Addresses of nodes; a master that answers anything else is not followed.
bool isListOfTexts(const XmlRpcValue& value) {
  bool texts = value.getType() == XmlRpcValue::TypeArray;
  for (int i = 0; texts && i < value.size(); ++i) {
    texts = value[i].getType() == XmlRpcValue::TypeString;
  }
  return texts;
}

std::string serviceUri() {
  return fmt::format("rosrpc://{}:{}", ros::network::getHost(), ros::ConnectionManager::instance()->getTCPPort());
}

void add(const std::string& method, const std::string& name, const std::string& uri, XmlRpcValue& calls) {
  XmlRpcValue call;
  call["methodName"] = method;
  call["params"] = callArguments({name, uri});
  calls[calls.size()] = call;
}

}  // namespace

RegistrationKeeper::RegistrationKeeper(std::function<std::vector<std::string>()> services,
                                       std::function<bool()> is_ending)
    : services_(std::move(services)),
      is_ending_(std::move(is_ending)),
      service_uri_(serviceUri()),
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

// What comes to the master while this node leaves it is taken back.
bool RegistrationKeeper::tell(const std::string& kind, const std::string& name, const std::string& detail,
                              const std::string& uri, XmlRpcValue& payload) {
  if (is_ending_()) {
    return false;
  }
  const bool done = callMaster(kLimit, "register" + kind, callArguments({name, detail, uri}), payload, stop_) == 1;
  if (is_ending_()) {
    XmlRpcValue ignored;
    callMaster(kLimit, "unregister" + kind, callArguments({name, kind == "Service" ? detail : uri}), ignored, stop_);
  }
  return done;
}

// Our own list of publishers or subscribers, in rows of [topic, type]. A subscription is also told of the publishers
// that have registered before, as the master does of those that come later.
bool RegistrationKeeper::tellTopics(const std::string& kind, const std::string& method) {
  XmlRpcValue topics = askSelf(method, callArguments({}), stop_);
  bool done = topics.getType() == XmlRpcValue::TypeArray;
  for (int i = 0; done && i < topics.size(); ++i) {
    const std::string& topic = topics[i][0];
    XmlRpcValue payload;
    done = tell(kind, topic, topics[i][1], ownUri(), payload) && (kind == "Publisher" || isListOfTexts(payload));
    if (done && kind == "Subscriber" && payload.size() > 0) {
      XmlRpcValue arguments = callArguments({topic});
      arguments[2] = payload;
      askSelf("publisherUpdate", arguments, stop_);
    }
  }
  return done;
}

// False where the master stopped answering; it is then asked again.
bool RegistrationKeeper::registerAnew() {
  XmlRpcValue payload;
  for (const std::string& service : services_()) {
    if (!tell("Service", service, service_uri_, ownUri(), payload)) {
      return false;
    }
  }
  return tellTopics("Publisher", "getPublications") && tellTopics("Subscriber", "getSubscriptions");
}

void RegistrationKeeper::check() {
  try {
    XmlRpcValue payload;
    const std::optional<int> known =
        callMaster(kLimit, "lookupNode", callArguments({ros::this_node::getName()}), payload, stop_);
    if (stop_ || is_ending_()) {
      return;
    }
    if (!known && !lost_) {
      ROS_WARN("the master does not answer; samples are served on, over the connections that are there");
    }
    lost_ = !known;
    incomplete_ = incomplete_ || (known && known != 1);
    if (incomplete_ && known && registerAnew()) {
      incomplete_ = false;
      ROS_WARN("the master did not know this node any more; registered again");
    }
  } catch (const XmlRpc::XmlRpcException& error) {
    ROS_WARN("the master answers what no master should: %s", error.getMessage().c_str());
  }
}

bool leaveMaster(double limit, const std::vector<std::string>& services) {
  const std::atomic<bool> stop{false};
  XmlRpcValue calls;
  calls.setSize(0);
  for (const auto& [list, method] :
       {std::pair("getPublications", "unregisterPublisher"), std::pair("getSubscriptions", "unregisterSubscriber")}) {
    XmlRpcValue topics = askSelf(list, callArguments({}), stop);
    for (int i = 0; topics.getType() == XmlRpcValue::TypeArray && i < topics.size(); ++i) {
      add(method, topics[i][0], ownUri(), calls);
    }
  }
  for (const std::string& service : services) {
    add("unregisterService", service, serviceUri(), calls);
  }
  XmlRpcValue arguments;
  arguments[0] = calls;
  XmlRpcValue answer;
  return callAny(limit, ros::master::getHost(), ros::master::getPort(), "system.multicall", arguments, answer, stop) &&
         answer.getType() == XmlRpcValue::TypeArray && answer.size() == calls.size();
}

}  // namespace rubber_suspension::roscpp_fixes
