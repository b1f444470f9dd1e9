// Calls of the master with time limits.
#include "ros_interface/master.h"

#include <fmt/format.h>
#include <pthread.h>
#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcClient.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <chrono>
#include <utility>

// This function of roscpp, which ros::init() calls, is not declared in any header.
namespace ros::master {
void init(const M_string& remappings);
}

namespace rubber_suspension::ros_interface {
namespace {

using XmlRpc::XmlRpcValue;

class Client : public XmlRpc::XmlRpcClient {
 public:
  using XmlRpcClient::XmlRpcClient;
  ~Client() override { close(); }

  // Calls a method and returns true if an answer comes that is not a fault.
  bool callWithin(double limit, const std::string& method, const XmlRpcValue& arguments, XmlRpcValue& answer,
                  const std::atomic<bool>* stop) {
    using Clock = std::chrono::steady_clock;
    constexpr double kTurn = 0.05;  // longest time until `stop` is noticed [s]
    const auto end = Clock::now() + std::chrono::duration<double>(limit);
    const bool begun = executeNonBlock(method.c_str(), arguments);
    while (begun && (stop == nullptr || !*stop) && Clock::now() < end && _connectionState != NO_CONNECTION) {
      _disp.work(std::min(kTurn, limit));
      if (executeCheckDone(answer)) {
        return !isFault() && answer.valid();
      }
    }
    return false;
  }

  // Returns true if the whole call was sent and the peer has not closed the connection.
  bool waitsForAnswer() const { return _connectionState == READ_HEADER || _connectionState == READ_RESPONSE; }
};

constexpr std::chrono::seconds kPeriod(2);
constexpr int kDone = 1;        // status of a successful answer
constexpr double kLimit = 3.0;  // limit of one call [s]; a master with thousands of topics may be slow

std::string ownUri() { return ros::XMLRPCManager::instance()->getServerURI(); }

std::string serviceUri() {
  return fmt::format("rosrpc://{}:{}", ros::network::getHost(), ros::ConnectionManager::instance()->getTCPPort());
}

void add(XmlRpcValue& calls, const std::string& method, const std::vector<std::string>& arguments) {
  const int i = calls.valid() ? calls.size() : 0;
  calls[i]["methodName"] = method;
  calls[i]["params"] = callArguments(arguments);
}

// Returns the calls that register all services and topics of this process, or nullopt if its topics are not known.
std::optional<XmlRpcValue> registrations(const std::vector<std::string>& services) {
  XmlRpcValue calls;
  for (const std::string& name : services) {
    add(calls, "registerService", {name, serviceUri(), ownUri()});
  }
  for (const std::string kind : {"Publisher", "Subscriber"}) {
    // The slave API of this process lists its topics.
    const auto topics =
        call(kLimit, ownUri(), kind == "Publisher" ? "getPublications" : "getSubscriptions", callArguments());
    if (!topics) {
      return std::nullopt;
    }
    for (int i = 0; i < (*topics)[2].size(); ++i) {
      add(calls, "register" + kind, {(*topics)[2][i][0], (*topics)[2][i][1], ownUri()});
    }
  }
  return calls;
}

struct Reply {
  std::optional<XmlRpcValue> answer;
  bool is_late = false;  // true if the peer received the call but did not answer within the limit
};

Reply callPeer(double limit, const std::string& uri, const std::string& method, const XmlRpcValue& arguments,
               const std::atomic<bool>* stop) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) {
    return {};
  }
  try {
    XmlRpcValue answer;
    Client client(host.c_str(), static_cast<int>(port), "/");
    if (client.callWithin(limit, method, arguments, answer, stop)) {
      return {answer, false};
    }
    return {std::nullopt, client.waitsForAnswer()};
  } catch (const XmlRpc::XmlRpcException&) {
    return {};  // the answer was not XML-RPC
  }
}

// Sends all calls to the master at once, because hundreds of separate calls, as roscpp makes, take seconds.
Reply callMaster(double limit, const XmlRpcValue& calls) {
  XmlRpcValue arguments;
  arguments[0] = calls;
  return callPeer(limit, ros::master::getURI(), "system.multicall", arguments, nullptr);
}

// Makes the calls and informs each subscription of the publishers that are already registered. The master itself
// announces later publishers. Returns false if a call failed.
bool registerAll(const XmlRpcValue& calls) {
  const auto answers = callMaster(kLimit, calls).answer;
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

XmlRpcValue callArguments(const std::vector<std::string>& arguments) {
  XmlRpcValue value;
  value[0] = ros::this_node::getName();
  for (const std::string& argument : arguments) {
    value[value.size()] = argument;
  }
  return value;
}

std::optional<XmlRpcValue> call(double limit, const std::string& uri, const std::string& method,
                                const XmlRpcValue& arguments, const std::atomic<bool>* stop) {
  return callPeer(limit, uri, method, arguments, stop).answer;
}

void giveUpMaster() { ros::master::init({{"__master", "http://127.0.0.1:1"}}); }

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
    ROS_WARN_THROTTLE(60.0, "the master does not answer; samples are still served over the existing connections");
    return;
  }
  incomplete_ = incomplete_ || static_cast<int>((*known)[0]) != kDone;
  if (!incomplete_) {
    return;
  }
  const auto calls = registrations(services_());
  incomplete_ = !calls || !registerAll(*calls);
  if (is_ending_()) {
    leaveMaster(kLimit);  // revokes registrations that were made while the node was unregistering
  } else if (!incomplete_) {
    ROS_WARN("the master no longer knew this node; the node registered again");
  }
}

std::optional<std::array<Registered, 3>> registeredNames(double limit) {
  const auto state = call(limit, ros::master::getURI(), "getSystemState", callArguments());
  if (!state) {
    return std::nullopt;
  }
  std::array<Registered, 3> names;
  try {
    for (int part = 0; part < 3; ++part) {
      const XmlRpcValue& rows = (*state)[2][part];
      for (int i = 0; i < rows.size(); ++i) {
        for (int j = 0; j < rows[i][1].size(); ++j) {
          const std::string& name = rows[i][0];
          const std::string& node = rows[i][1][j];
          names[static_cast<std::size_t>(part)][name].push_back(node);
        }
      }
    }
  } catch (const XmlRpc::XmlRpcException&) {
    return std::nullopt;
  }
  return names;
}

bool leaveMaster(double limit) {
  constexpr std::array<const char*, 3> kMethods = {"unregisterPublisher", "unregisterSubscriber", "unregisterService"};
  const auto names = registeredNames(limit);
  XmlRpcValue calls;
  for (std::size_t part = 0; names && part < kMethods.size(); ++part) {
    for (const auto& [name, nodes] : (*names)[part]) {
      if (std::find(nodes.begin(), nodes.end(), ros::this_node::getName()) != nodes.end()) {
        add(calls, kMethods[part], {name, part == 2 ? serviceUri() : ownUri()});
      }
    }
  }
  if (!calls.valid()) {
    return names.has_value();
  }
  constexpr double kSendLimit = 1.0;  // [s]; a busy master answers late, but executes the calls
  const Reply reply = callMaster(kSendLimit, calls);
  return reply.answer || reply.is_late;
}

}  // namespace rubber_suspension::ros_interface
