// Keeps a node that is told to stay on the loopback interface there with its slave API, too.
#pragma once

#include <cstdint>
#include <string>

namespace rubber_suspension::ros_interface {

/// True where ROS_IP or ROS_HOSTNAME keeps this process to the loopback interface.
bool isKeptToLoopback();

/// roscpp then listens for samples on the loopback interface only, but for the calls of its slave API on all: bind
/// these to the interface as well. Does nothing where isKeptToLoopback() is false. Call once ROS runs. Returns why that
/// was not possible, or nothing. Linux before 5.7 permits it to root only.
std::string keepSlaveApiToLoopback();

/// The interface that this process listens on for a TCP port; empty for all of them, or where it does not listen.
std::string interfaceOf(std::uint32_t port);

}  // namespace rubber_suspension::ros_interface
