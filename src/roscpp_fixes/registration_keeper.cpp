// Registers the node again when the master was restarted.
#include "roscpp_fixes/registration_keeper.h"

#include <fmt/format.h>
#include <pthread.h>
#include <ros/connection_manager.h>
#include <ros/console.h>
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
constexpr int kDone = 1;        // status of an answer
constexpr double kLimit = 3.0;  // for one call [s]; a master with thousands of topics may be slow

std::string ownUri() { return ros::XMLRPCManager::instance()->getServerURI(); }

std::string serviceUri() {
  return fmt::format("rosrpc://{}:{}", ros::network::getHost(), ros::ConnectionManager::instance()->getTCPPort());
}

void add(XmlRpcValue& calls, const std::string& method, const std::vector<std::string>& arguments) {
  const int i = calls.valid() ? calls.size() : 0;
  calls[i]["methodName"] = method;
  calls[i]["params"] = callArguments(arguments);
}

// The calls of the master that register all services and topics of this process.
struct Registrations {
  // The topics are those that this process lists for others (slave API).
  explicit Registrations(const std::vector<std::string>& services) {
    for (const std::string& name : services) {
      add(come, "registerService", {name, serviceUri(), ownUri()});
    }
    for (const std::string kind : {"Publisher", "Subscriber"}) {
      const auto topics =
          call(kLimit, ownUri(), kind == "Publisher" ? "getPublications" : "getSubscriptions", callArguments());
      complete = complete && topics;
      for (int i = 0; topics && i < (*topics)[2].size(); ++i) {
        add(come, "register" + kind, {(*topics)[2][i][0], (*topics)[2][i][1], ownUri()});
      }
    }
  }

  bool complete = true;  // all are known
  XmlRpcValue come;
};

// All calls at once, where roscpp makes one after the other and takes seconds for hundreds. A subscription is also told
// of the publishers that have registered before, as the master does of later ones. False where something failed.
bool callMaster(double limit, const XmlRpcValue& calls) {
  XmlRpcValue arguments;
  arguments[0] = calls;
  const auto answers = call(limit, ros::master::getURI(), "system.multicall", arguments);
  bool done = answers && answers->size() == calls.size();
  for (int i = 0; done && i < calls.size(); ++i) {
    const XmlRpcValue& answer = (*answers)[i][0];
    done = static_cast<int>(answer[0]) == kDone;
    if (calls[i]["methodName"] == XmlRpcValue("registerSubscriber") && answer[2].size() > 0) {
      XmlRpcValue update = callArguments({calls[i]["params"][1]});
      update[2] = answer[2];
      call(kLimit, ownUri(), "publisherUpdate", update);
    }
  }
  return done;
}

}  // namespace

RegistrationKeeper::RegistrationKeeper(std::function<std::vector<std::string>()> services,
                                       std::function<bool()> is_ending)
    : services_(std::move(services)), is_ending_(std::move(is_ending)), thread_([this] { run(); }) {}

void RegistrationKeeper::stop() {
  if (thread_.joinable()) {
    stop_ = true;
    stopping_.set_value();
    thread_.join();
  }
}

void RegistrationKeeper::run() {
  pthread_setname_np(pthread_self(), "master");
  const std::future<void> stopping = stopping_.get_future();
  while (stopping.wait_for(kPeriod) == std::future_status::timeout) {
    try {
      check();
    } catch (const XmlRpc::XmlRpcException& error) {
      ROS_WARN_THROTTLE(60.0, "invalid reply from the ROS master: %s", error.getMessage().c_str());
    }
  }
}

void RegistrationKeeper::check() {
  const auto known =
      call(kLimit, ros::master::getURI(), "lookupNode", callArguments({ros::this_node::getName()}), &stop_);
  if (stop_ || is_ending_()) {
    return;
  }
  if (!known) {
    ROS_WARN_THROTTLE(60.0, "the master does not answer; samples are served on, over the connections that are there");
    return;
  }
  incomplete_ = incomplete_ || static_cast<int>((*known)[0]) != kDone;
  if (!incomplete_) {
    return;
  }
  const Registrations all(services_());
  incomplete_ = !callMaster(kLimit, all.come) || !all.complete;
  if (is_ending_()) {
    leaveMaster(kLimit);  // what comes to the master while this node leaves it is taken back
  } else if (!incomplete_) {
    ROS_WARN("the master did not know this node any more; registered again");
  }
}

bool leaveMaster(double limit) {
  try {
    const auto state = call(limit, ros::master::getURI(), "getSystemState", callArguments());
    const std::string& own = ros::this_node::getName();
    XmlRpcValue calls;
    int part = 0;
    for (const std::string kind : {"Publisher", "Subscriber", "Service"}) {
      for (int i = 0; state && i < (*state)[2][part].size(); ++i) {
        const XmlRpcValue& row = (*state)[2][part][i];  // a name and its nodes
        for (int j = 0; j < row[1].size(); ++j) {
          if (row[1][j] == XmlRpcValue(own)) {
            add(calls, "unregister" + kind, {row[0], kind == "Service" ? serviceUri() : ownUri()});
          }
        }
      }
      ++part;
    }
    return state && (!calls.valid() || callMaster(limit, calls));
  } catch (const XmlRpc::XmlRpcException&) {
    return false;
  }
}

}  // namespace rubber_suspension::roscpp_fixes
