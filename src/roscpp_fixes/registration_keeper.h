// Registers the node again when the master was restarted: without, nobody new would find it, for ever.
#pragma once

#include <atomic>
#include <functional>
#include <future>
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
  ~RegistrationKeeper() { stop(); }

  /// End the thread, and take all topics and services of this process off the master. False where the master did not do
  /// it within `limit` [s].
  bool leaveMaster(double limit);

 private:
  void stop();
  void run();
  void check();

  const std::function<std::vector<std::string>()> services_;
  const std::function<bool()> is_ending_;
  const std::string service_uri_;
  bool incomplete_ = false;  // registering again was not finished
  std::atomic<bool> stop_{false};
  std::promise<void> stopping_;
  std::thread thread_;
};

}  // namespace rubber_suspension::roscpp_fixes
