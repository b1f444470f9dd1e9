// The node as a nodelet. It exchanges messages with other nodelets of the same manager without copies.
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "ros_interface/simulate_node.h"
#include "ros_interface/termination.h"

namespace rubber_suspension::ros_interface {

class SimulateNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      node_ = std::make_unique<SimulateNode>(getNodeHandle(), getPrivateNodeHandle(), isEnding);
    } catch (const std::exception& error) {
      NODELET_FATAL("%s", error.what());
      throw;  // the manager then reports that the nodelet was not loaded
    }
  }

  std::unique_ptr<SimulateNode> node_;
};

}  // namespace rubber_suspension::ros_interface

PLUGINLIB_EXPORT_CLASS(rubber_suspension::ros_interface::SimulateNodelet, nodelet::Nodelet)
