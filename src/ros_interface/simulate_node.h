// The node: components, their topics, services and diagnostics, put together for a process of its own or a nodelet.
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <vector>

#include "node/channel_group.h"
#include "ros_interface/bundle_server.h"
#include "ros_interface/command_line.h"
#include "ros_interface/live_diagnoser.h"
#include "ros_interface/node_diagnostics.h"
#include "ros_interface/node_services.h"
#include "ros_interface/node_settings.h"
#include "ros_interface/sample_server.h"
#include "ros_interface/serving_thread.h"
#include "roscpp_fixes/registration_keeper.h"

namespace rubber_suspension::ros_interface {

/// The program `simulate`: serve until a signal comes or ROS is shut down, then take the node off the master. The
/// process is to return at once after that. Throws as SimulateNode does.
void runSimulateNode(RosCommandLine& line);

/// Components, by their resolved names, that a node of this process serves: of two nodelets in one manager the second
/// cannot serve the same ones.
class ClaimedComponents {
 public:
  ClaimedComponents() = default;
  ~ClaimedComponents();
  ClaimedComponents(const ClaimedComponents&) = delete;
  ClaimedComponents& operator=(const ClaimedComponents&) = delete;

  /// Throws std::invalid_argument that names the node that has claimed it before.
  void claim(const std::string& component, const std::string& node);

 private:
  std::vector<std::string> components_;
};

/// Serves samples in threads of its own; services and diagnostics run on the queue of the handles given.
class SimulateNode {
 public:
  /// Throws std::exception with one line that says what is wrong; then nothing was advertised. Throws io::Cancelled
  /// where the process is to end before the node serves.
  SimulateNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~SimulateNode();
  SimulateNode(const SimulateNode&) = delete;
  SimulateNode& operator=(const SimulateNode&) = delete;

  /// No thread of the node calls the master any more. Returns the resolved names of the node's services.
  std::vector<std::string> registerNoMore();

 private:
  void start();
  void makeChannels();
  static void keepToLoopback();
  void setUpRealTime();
  void startServing();
  void startThreads();
  void advertiseServices();
  std::vector<std::string> services() const;
  io::ComponentDescription foundModel(const std::string& component) const;

  ros::NodeHandle handle_;
  ros::NodeHandle private_handle_;
  NodeSettings settings_;
  ClaimedComponents claimed_;
  std::vector<std::unique_ptr<node::ComponentChannel>> channels_;
  std::unique_ptr<node::ChannelGroup> group_;
  std::vector<std::unique_ptr<ServingThread>> threads_;
  std::vector<std::unique_ptr<SampleServer>> servers_;
  std::unique_ptr<BundleServer> bundle_;
  std::unique_ptr<LiveDiagnoser> live_;  // where ~diagnose is true
  std::unique_ptr<NodeDiagnostics> diagnostics_;
  std::unique_ptr<NodeServices> services_;
  std::shared_ptr<ros::ServiceServer> loggers_;
  std::unique_ptr<roscpp_fixes::RegistrationKeeper> registration_;
};

}  // namespace rubber_suspension::ros_interface
