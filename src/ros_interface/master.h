// The master, where roscpp's own calls of it wait for ever if it hangs, and where a new one does not know the node.
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

/// The arguments of a call, this node's name first.
XmlRpc::XmlRpcValue callArguments(const std::vector<std::string>& arguments = {});

/// Call a method at an address (http://HOST:PORT) within `limit` [s], less once `stop` is set. Returns what came back,
/// from masters and nodes [status, text, payload] with status 1 where it was done; nothing where no answer came, or a
/// fault. What comes back may be anything: XmlRpcValue throws XmlRpcException where it is not what it is taken for.
std::optional<XmlRpc::XmlRpcValue> call(double limit, const std::string& uri, const std::string& method,
                                        const XmlRpc::XmlRpcValue& arguments, const std::atomic<bool>* stop = nullptr);

/// True if the master at this address answers within `limit` [s].
inline bool masterAnswers(double limit, const std::string& uri = ros::master::getURI()) {
  return call(limit, uri, "getPid", callArguments()).has_value();
}

/// Names that are registered at the master, with the nodes of each.
using Registered = std::map<std::string, std::vector<std::string>>;

/// Returns the names registered at the master: publishers and subscribers of topics, and services; nullopt without a
/// valid answer within `limit` [s].
std::optional<std::array<Registered, 3>> registeredNames(double limit);

/// Unregisters all that the master knows of this process, as far as starting up has come. Returns false if the master
/// did not say within `limit` [s] what it knows, or did not accept the calls; a busy master may still be executing them
/// on return. Nothing may register meanwhile.
bool leaveMaster(double limit);

/// From now on roscpp calls nobody in the master's place: each call fails at once. For the end of a process whose
/// master hangs, since roscpp waits without a limit. No other thread may call the master meanwhile.
void giveUpMaster();

/// Registers the node again when the master was restarted: without, nobody new would find it, for ever. Asks the master
/// every two seconds whether it knows this process, in a thread of its own and never for longer than a time limit: a
/// master that hangs, or a cable that is pulled, holds up nothing else. Once the process is to end nothing is
/// registered any more. Connections between nodes outlive their master, so samples are served all the while, over
/// connections that are not touched.
class RegistrationKeeper {
 public:
  /// `services`: resolved names of those that there are now; `is_ending`: whether the process is to end. Both are
  /// called in the thread.
  RegistrationKeeper(std::function<std::vector<std::string>()> services, std::function<bool()> is_ending);
  ~RegistrationKeeper() { stop(); }

  /// End the thread: nothing is registered any more.
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
