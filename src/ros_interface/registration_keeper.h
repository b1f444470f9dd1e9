// Registers the node anew when the master was restarted: without, nobody new would find it, for ever.
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// What the master says of this process.
enum class Registration { known, unknown, no_answer };

/// Ask the master, without waiting for one.
Registration askMaster();

/// Register all topics of this process, and the services given, with a master that does not know them, and connect to
/// the publishers that have registered before. Connections that are there already are not touched.
void registerAnew(const std::vector<std::string>& services);

/// Asks the master every two seconds, on the handle's callback queue. Connections between nodes outlive their master,
/// so samples are served all the while.
class RegistrationKeeper {
 public:
  /// `services` are resolved names.
  RegistrationKeeper(ros::NodeHandle& handle, const std::vector<std::string>& services);

 private:
  void check();

  std::vector<std::string> services_;
  bool lost_ = false;
  ros::WallTimer timer_;
};

}  // namespace rubber_suspension::ros_interface
