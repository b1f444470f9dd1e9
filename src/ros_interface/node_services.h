// Services of the node: reset, save and load the state, enable, reload, promote and roll back.
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "node/channel_group.h"
#include "ros_interface/live_diagnoser.h"
#include "ros_interface/node_settings.h"

namespace rubber_suspension::ros_interface {

/// Reads the states in `path` and loads each state into its channel. Unless the file contains the states of exactly
/// these components, throws node::FileError or std::invalid_argument and changes nothing.
void loadStates(const std::string& path, node::ChannelGroup& group);

/// Services ~reset, ~save_state, ~load_state, ~reload (std_srvs/Trigger) and ~set_enabled (std_srvs/SetBool) for all
/// components, and ~reset_component and ~enable_component for one component by its name. `COMPONENT/promote` and
/// `COMPONENT/rollback` exist if a model can be promoted or has been promoted. Services access only files that private
/// parameters of the node name, so that a caller cannot choose a path.
class NodeServices {
 public:
  /// The group and the live diagnosis, if any, must outlive the object. Throws io::Cancelled if the process is to end
  /// before all services are advertised.
  NodeServices(ros::NodeHandle& handle, ros::NodeHandle& private_handle, const NodeSettings& settings,
               node::ChannelGroup& group, const LiveDiagnoser* live);

  /// Returns the resolved names of all services of the node, including those for loggers. Thread-safe.
  std::vector<std::string> names() const;

 private:
  /// Advertises a service. `action` returns the message of a success; a failure has the message of its exception.
  template <class Service, class Action>
  void advertise(ros::NodeHandle& handle, const std::string& name, Action action);
  void advertisePromotions();

  std::string save() const;
  std::string load();
  std::string reload() const;
  std::string promote(node::ComponentChannel& channel) const;

  ros::NodeHandle handle_;
  ros::NodeHandle private_handle_;
  NodeSettings settings_;
  node::ChannelGroup& group_;
  const LiveDiagnoser* live_;
  mutable std::mutex mutex_;  // guards servers_
  std::vector<ros::ServiceServer> servers_;
  std::set<std::string> promotable_;  // components that have services for promotion
};

}  // namespace rubber_suspension::ros_interface
