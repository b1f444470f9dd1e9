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
  int queue_size = 10000;     ///< number of samples that can wait on each topic before the oldest is lost
  int threads = 1;            ///< serving threads; components are assigned to them in turn
  int realtime_priority = 0;  ///< SCHED_FIFO priority of the serving threads, 0 for none
  bool without_rig = false;   ///< omit the elements of the rig that measured the components
  bool lock_memory = false;   ///< keep all memory of the process resident (mlockall)
  std::string state_file;     ///< file of ~save_state and ~load_state; if it is empty, these services fail
  bool load_state = false;    ///< continue from state_file at the start, if the file exists
  node::GapSettings gap;      ///< window and thresholds of the live gap
  node::PromotionSettings promotion;
  bool diagnose = false;  ///< diagnose while the bench runs
  LiveDiagnoserSettings live;
  std::string promote_file;  ///< component file with models for COMPONENT/promote; empty: models of the live diagnosis
};

/// Reads and checks all private parameters except those of the components. Throws std::invalid_argument, which states
/// the parameter, its value and the accepted values, also for an unknown parameter.
NodeSettings readNodeSettings(const ros::NodeHandle& private_handle);

/// Reads the components from the regular file ~config_file or from the parameters under ~components, of which exactly
/// one must be given. Omits the elements of the rig if `without_rig` is set. Throws std::invalid_argument or
/// ComponentFileError, also for a component with the name of the node or of one of its topics or services. Throws
/// io::Cancelled if the process is to end.
std::vector<io::ComponentDescription> readComponents(const ros::NodeHandle& private_handle,
                                                     const NodeSettings& settings);

/// Returns the parameters as text for --help.
std::string describeNodeSettings();

}  // namespace rubber_suspension::ros_interface
