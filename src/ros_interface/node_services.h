// What a bench may ask of the node besides forces: reset, save and load the state, enable, reload.
#pragma once

#include <ros/node_handle.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <functional>
#include <string>
#include <vector>

#include "node/channel_group.h"
#include "ros_interface/node_settings.h"

namespace rubber_suspension::ros_interface {

/// Read the states of `path` and put every channel on its own. All or none: throws node::FileError or
/// std::invalid_argument where the file is not one of exactly these components, and nothing has changed.
void loadStates(const std::string& path, node::ChannelGroup& group);

/// Replace the models of all channels by those of the descriptions. All or none: throws std::invalid_argument where the
/// components are not those of the channels or one has no solution. A component whose elements are the same continues;
/// another one starts as new.
void exchangeModels(const std::vector<io::ComponentDescription>& descriptions, double max_gap,
                    node::ChannelGroup& group);

/// What the live diagnosis found for a component; throws std::invalid_argument that says why there is nothing.
using FoundModel = std::function<io::ComponentDescription(const std::string& component)>;

/// Services ~reset, ~save_state, ~load_state, ~reload (std_srvs/Trigger) and ~set_enabled (std_srvs/SetBool) for all
/// components, `COMPONENT/reset`, `COMPONENT/set_enabled`, `COMPONENT/promote` and `COMPONENT/rollback` for one. They
/// read and write nothing but the files that the node's private parameters name: whoever calls a service names no path.
class NodeServices {
 public:
  /// The group must outlive the object.
  NodeServices(ros::NodeHandle& handle, ros::NodeHandle& private_handle, const NodeSettings& settings,
               node::ChannelGroup& group, FoundModel found_model);

  /// Resolved names of all services.
  std::vector<std::string> names() const;

 private:
  using Trigger = std_srvs::Trigger;
  using SetBool = std_srvs::SetBool;

  /// A Trigger service; `action` returns the message of success, its exceptions become that of failure.
  void advertise(ros::NodeHandle& handle, const std::string& name, std::function<std::string()> action);
  void advertiseSwitch(ros::NodeHandle& handle, const std::string& name, std::function<void(bool)> set_enabled);

  std::string save() const;
  std::string load() const;
  std::string reload() const;
  std::string promote(node::ComponentChannel& channel) const;

  ros::NodeHandle private_handle_;
  NodeSettings settings_;
  node::ChannelGroup& group_;
  FoundModel found_model_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace rubber_suspension::ros_interface
