// Registers the node again when the master was restarted: without, nobody new would find it, for ever.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rubber_suspension::roscpp_fixes {

/// Asks the master every two seconds whether it knows this process, in a thread of its own and never for longer than a
/// time limit: a master that hangs, or a cable that is pulled, holds up nothing else. Once the process is to end
/// nothing is registered any more. Connections between nodes outlive their master, so samples are served all the while,
/// over connections that are not touched.
class RegistrationKeeper {
 public:
  /// `services`: resolved names of those that there are now; `is_ending`: whether the process is to end. Both are
  /// called in the thread.
  RegistrationKeeper(std::function<std::vector<std::string>()> services, std::function<bool()> is_ending);
  ~RegistrationKeeper();
  RegistrationKeeper(const RegistrationKeeper&) = delete;
  RegistrationKeeper& operator=(const RegistrationKeeper&) = delete;

 private:
  void run();
  void check();
  bool registerAnew();
  bool tell(const std::string& kind, const std::string& name, const std::string& detail, const std::string& uri,
            XmlRpc::XmlRpcValue& payload);
  bool tellTopics(const std::string& kind, const std::string& method);

  const std::function<std::vector<std::string>()> services_;
  const std::function<bool()> is_ending_;
  const std::string service_uri_;
  bool lost_ = false;        // the master did not answer
  bool incomplete_ = false;  // registering again was not finished
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable stopping_;
  std::thread thread_;
};

/// Take all topics of this process and these services, by their resolved names, off the master: in one call, where
/// roscpp makes one for each and takes seconds for hundreds. False where the master did not do it within `limit` [s].
bool leaveMaster(double limit, const std::vector<std::string>& services);

}  // namespace rubber_suspension::roscpp_fixes
