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

/// Take all that the master knows of this process off it, as far as starting up has come. False where the master did
/// not do it within `limit` [s]. Nothing registers meanwhile.
bool leaveMaster(double limit);

}  // namespace rubber_suspension::roscpp_fixes
