// Calls of the master with time limits, which the calls of roscpp lack, and registration at a restarted master.
#pragma once

#include <ros/master.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <array>
#include <atomic>
#include <functional>
#include <future>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Returns the arguments of a call, with this node's name first.
XmlRpc::XmlRpcValue callArguments(const std::vector<std::string>& arguments = {});

/// Calls a method at an address (http://HOST:PORT) and waits for the answer at most `limit` [s] or until `stop` is set.
/// Returns the answer, or nullopt if there is none or it is a fault. Masters and nodes answer [status, text, payload]
/// with status 1 for success, but an answer may have any type: XmlRpcValue throws XmlRpcException if it is read as
/// another type.
std::optional<XmlRpc::XmlRpcValue> call(double limit, const std::string& uri, const std::string& method,
                                        const XmlRpc::XmlRpcValue& arguments, const std::atomic<bool>* stop = nullptr);

/// Returns true if the master at this address answers within `limit` [s].
inline bool masterAnswers(double limit, const std::string& uri = ros::master::getURI()) {
  return call(limit, uri, "getPid", callArguments()).has_value();
}

/// Names that are registered at the master, with the nodes that registered each name.
using Registered = std::map<std::string, std::vector<std::string>>;

/// Returns the registered publishers, subscribers and services, or nullopt without a valid answer within `limit` [s].
std::optional<std::array<Registered, 3>> registeredNames(double limit);

/// Unregisters all topics and services that the master knows of this process; works also during start-up. Returns false
/// if the master did not list them within `limit` [s] or did not accept the calls. A busy master may still execute the
/// calls after the return. The process must register nothing meanwhile.
bool leaveMaster(double limit);

/// Makes every further call of the master by roscpp fail at once. It is for the end of a process whose master hangs,
/// because roscpp would wait without a limit. No other thread may call the master meanwhile.
void giveUpMaster();

/// Registers the node again after a restart of the master, because new peers could not find the node otherwise. A
/// thread asks the master every two seconds whether it knows this process. The call has a time limit and a thread of
/// its own, so that a hanging master or an unplugged cable blocks nothing else. Once the process is to end, nothing is
/// registered any more. Connections between nodes outlive their master, so samples are served without interruption.
class RegistrationKeeper {
 public:
  /// `services` returns the resolved names of the present services. `is_ending` returns true if the process is to end.
  /// The thread calls both functions.
  RegistrationKeeper(std::function<std::vector<std::string>()> services, std::function<bool()> is_ending);
  ~RegistrationKeeper() { stop(); }

  /// Ends the thread, after which nothing is registered.
  void stop();

 private:
  void run();
  void check();

  const std::function<std::vector<std::string>()> services_;
  const std::function<bool()> is_ending_;
  bool incomplete_ = false;  // true if the node has not registered everything again
  std::atomic<bool> stop_{false};
  std::promise<void> stopping_;
  std::thread thread_;
};

}  // namespace rubber_suspension::ros_interface
