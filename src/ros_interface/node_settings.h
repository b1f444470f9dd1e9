// Settings of the node besides its components: one table of private parameters, checked strictly.
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "node/live_gap.h"
#include "node/promotion.h"
#include "ros_interface/live_diagnoser.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::ros_interface {

/// The node's private parameters with their defaults.
struct NodeSettings {
  double max_gap = 0.5;       ///< longest time between two samples that is not reported [s]
  int queue_size = 10000;     ///< samples that may wait per topic before the oldest is lost
  int threads = 1;            ///< serving threads; components are dealt out to them in turn
  int realtime_priority = 0;  ///< SCHED_FIFO priority of the serving threads, 0 for none
  bool without_rig = false;   ///< leave out what belongs to the rig that measured the components
  bool lock_memory = false;   ///< keep all memory of the process resident (mlockall)
  std::string state_file;     ///< where ~save_state and ~load_state keep the state; empty: services refuse
  bool load_state = false;    ///< go on from state_file at the start, if the file is there
  node::GapSettings gap;      ///< window and thresholds of the live gap
  node::PromotionSettings promotion;
  bool diagnose = false;  ///< diagnose while the bench runs
  LiveDiagnoserSettings live;
  std::string promote_file;  ///< component file with what COMPONENT/promote puts in place; empty: what was found live
};

/// Read and check all private parameters but those of the components. Throws std::invalid_argument: parameter, value
/// and what would be accepted; an unknown parameter is refused too.
NodeSettings readNodeSettings(const ros::NodeHandle& private_handle);

/// The components, without their rig where the settings say so, from the file that ~config_file names or from the
/// parameters under ~components, of which exactly one must be given; the file must be a regular one. Throws
/// std::invalid_argument or ComponentFileError, also for a component that is named as the node, or as one of its topics
/// or services; of a file it says where its path came from. Throws io::Cancelled where the process is to end.
std::vector<io::ComponentDescription> readComponents(const ros::NodeHandle& private_handle,
                                                     const NodeSettings& settings);

/// The table above as text for --help.
std::string describeNodeSettings();

}  // namespace rubber_suspension::ros_interface
