// The node: components with their topics, services and diagnostics, in a process of its own or as a nodelet.
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "node/channel_group.h"
#include "ros_interface/bundle_server.h"
#include "ros_interface/command_line.h"
#include "ros_interface/live_diagnoser.h"
#include "ros_interface/master.h"
#include "ros_interface/node_diagnostics.h"
#include "ros_interface/node_services.h"
#include "ros_interface/node_settings.h"
#include "ros_interface/sample_server.h"
#include "ros_interface/serving_thread.h"

namespace rubber_suspension::ros_interface {

/// Runs the program `simulate`. It serves until a signal comes or ROS is shut down, and then unregisters the node. The
/// process must end right after the return. Throws as SimulateNode does.
void runSimulateNode(RosCommandLine& line);

/// Serves samples in threads of its own. Services and diagnostics run on the callback queue of the given handles.
class SimulateNode {
 public:
  /// `is_ending` is called repeatedly. Throws io::Cancelled if it returns true before the node serves, and
  /// std::exception, with a message of one line, for other errors. After an exception nothing remains advertised.
  SimulateNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
               const std::function<bool()>& is_ending);
  ~SimulateNode();

  /// Ends the supervision of the registration. After that, nothing is registered any more.
  void stopRegistering() { registration_->stop(); }

 private:
  void makeChannels();
  void startServing();
  void advertiseServices();

  ros::NodeHandle handle_;
  ros::NodeHandle private_handle_;
  NodeSettings settings_;
  std::vector<std::shared_ptr<const std::string>> claims_;  // one for each component
  std::vector<std::unique_ptr<node::ComponentChannel>> channels_;
  std::unique_ptr<node::ChannelGroup> group_;
  std::vector<std::unique_ptr<ServingThread>> threads_;
  std::vector<std::unique_ptr<SampleServer>> servers_;
  std::vector<std::unique_ptr<BundleServer>> bundles_;  // for displacements and, if needed, for poses
  std::unique_ptr<LiveDiagnoser> live_;                 // null unless ~diagnose is true
  std::unique_ptr<NodeDiagnostics> diagnostics_;
  std::unique_ptr<NodeServices> services_;
  std::shared_ptr<ros::ServiceServer> loggers_;
  std::unique_ptr<RegistrationKeeper> registration_;
};

}  // namespace rubber_suspension::ros_interface
