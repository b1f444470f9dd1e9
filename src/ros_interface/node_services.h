// Services of the node besides forces: reset, save and load the state, enable, reload.
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

/// Read the states of `path` and put every channel on its own. All or none: throws node::FileError or
/// std::invalid_argument where the file is not one of exactly these components, and nothing has changed.
void loadStates(const std::string& path, node::ChannelGroup& group);

/// Services ~reset, ~save_state, ~load_state, ~reload (std_srvs/Trigger) and ~set_enabled (std_srvs/SetBool) for all
/// components, ~reset_component and ~enable_component for one by its name. `COMPONENT/promote` and `COMPONENT/rollback`
/// are there where something can be promoted, or was. They read and write nothing but the files that the node's private
/// parameters name: whoever calls a service names no path.
class NodeServices {
 public:
  /// The group must outlive the object, and so must the live diagnosis, if there is one. Throws io::Cancelled where the
  /// process is to end meanwhile.
  NodeServices(ros::NodeHandle& handle, ros::NodeHandle& private_handle, const NodeSettings& settings,
               node::ChannelGroup& group, const LiveDiagnoser* live);

  /// Resolved names of all services of the node, those about loggers among them. From any thread.
  std::vector<std::string> names() const;

 private:
  /// `action` returns the message of success, its exceptions become that of failure.
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
  mutable std::mutex mutex_;  // of the servers
  std::vector<ros::ServiceServer> servers_;
  std::set<std::string> promotable_;  // components whose promotion has its services
};

}  // namespace rubber_suspension::ros_interface
