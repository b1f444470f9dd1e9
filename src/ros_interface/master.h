// Calls of the master with time limits, which roscpp's own calls lack, and registration at a restarted master.
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

/// Calls a method at an address (http://HOST:PORT) within `limit` [s], or until `stop` is set. Returns the answer, for
/// masters and nodes [status, text, payload] with status 1 for success; nullopt without an answer or after a fault. An
/// answer may have any type: XmlRpcValue throws XmlRpcException if it is read as another.
std::optional<XmlRpc::XmlRpcValue> call(double limit, const std::string& uri, const std::string& method,
                                        const XmlRpc::XmlRpcValue& arguments, const std::atomic<bool>* stop = nullptr);

/// Returns true if the master at this address answers within `limit` [s].
inline bool masterAnswers(double limit, const std::string& uri = ros::master::getURI()) {
  return call(limit, uri, "getPid", callArguments()).has_value();
}

/// Names that are registered at the master, with the nodes of each.
using Registered = std::map<std::string, std::vector<std::string>>;

/// Returns the names registered at the master: publishers and subscribers of topics, and services; nullopt without a
/// valid answer within `limit` [s].
std::optional<std::array<Registered, 3>> registeredNames(double limit);

/// Unregisters all that the master knows of this process, also during start-up. Returns false if the master did not
/// list it within `limit` [s], or did not accept the calls; a busy master may still be executing them on return.
/// Nothing may register meanwhile.
bool leaveMaster(double limit);

/// Lets each further call of the master by roscpp fail at once, for the end of a process whose master hangs, because
/// roscpp waits without a limit. No other thread may call the master meanwhile.
void giveUpMaster();

/// Registers the node again after a restart of the master, because new peers could not find it otherwise. A thread asks
/// the master every two seconds whether it knows this process, with a time limit, so that a hanging master or an
/// unplugged cable blocks nothing else. Once the process is to end, nothing is registered any more. Connections between
/// nodes outlive their master, so samples are served without interruption.
class RegistrationKeeper {
 public:
  /// `services` returns the resolved names of the present services; `is_ending` returns true if the process is to end.
  /// Both are called in the thread.
  RegistrationKeeper(std::function<std::vector<std::string>()> services, std::function<bool()> is_ending);
  ~RegistrationKeeper() { stop(); }

  /// Ends the thread, after which nothing is registered.
  void stop();

 private:
  void run();
  void check();

  const std::function<std::vector<std::string>()> services_;
  const std::function<bool()> is_ending_;
  bool incomplete_ = false;  // registering again was not finished
  std::atomic<bool> stop_{false};
  std::promise<void> stopping_;
  std::thread thread_;
};

}  // namespace rubber_suspension::ros_interface
