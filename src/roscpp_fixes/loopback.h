// Keeps a node that is told to stay on the loopback interface there with its slave API, too.
#pragma once

#include <string>

namespace rubber_suspension::roscpp_fixes {

/// Where ROS_IP or ROS_HOSTNAME keeps this process to the loopback interface, roscpp listens for samples there only,
/// but for the calls of its slave API on all interfaces: bind these to it as well. Call once ROS runs. Returns why that
/// was not possible, or nothing. Linux before 5.7 permits it to root only.
std::string keepSlaveApiToLoopback();

}  // namespace rubber_suspension::roscpp_fixes
