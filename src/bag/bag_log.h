// Reads the node's topics in a ROS bag as a log, and writes a log as these topics. Unlike bag/bag_writer.h, this header
// includes no headers of ROS, because headers of ROS take long to compile.
#pragma once

#include <memory>
#include <string>

#include "rubber_suspension/component/rotation_measure.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::bag {

/// Reads one component from topics that end in <component>/displacement and, if recorded, <component>/measured_force
/// and <component>/temperature. An empty name selects the only component of the bag.
/// The log has the stamps of the displacement. Forces with the same stamps are assigned to them, and `counts` is 0 for
/// samples without a force. Forces with other stamps, from a clock of their own, are interpolated linearly, with a
/// note. Messages are sorted by their stamps, with a note if one overtook another.
/// If the format names columns, these are fields of messages of any type (bag/message_field.h), one of them the
/// displacement, in SI units or the units of the format.
/// Throws LogError that names bag, topic, message and reason. If stamps do not increase, the error also names the
/// option that replaces them by a sampling rate or by the times of receipt.
log::Log readBagLog(const std::string& path, const std::string& component = "", const log::LogFormat& format = {});

/// Reads a component of six directions from the topics <component>/pose and, if recorded, <component>/measured_wrench
/// and <component>/temperature. Stamps are assigned as in readBagLog(). Rotations are converted to `measure`. Throws
/// LogError, also for stamps that do not increase and for quaternions that the node would drop.
log::PoseLog readBagPoses(const std::string& path, const std::string& component, component::RotationMeasure measure);

/// Returns true if the path ends in .bag or the file begins like a bag.
bool isBagPath(const std::string& path);

/// Reads a log from a bag, or from any file that log::readLog() accepts.
log::Log readAnyLog(const std::string& path, const std::string& component = "", const log::LogFormat& format = {});

/// Reads the log of a bag, or all logs that log::readLogs() reads from another file.
std::vector<log::Log> readAnyLogs(const std::string& path, const std::string& component, const log::LogFormat& format);

/// Opens logs for reading block by block, as log::openLogs() does. The log of a bag is kept in memory.
log::LogSources openAnyLogs(const std::string& path, const std::string& component, const log::LogFormat& format);

/// Writes displacements, any measured forces, and any temperatures where they change. Throws LogError.
void writeBagLog(const std::string& path, const std::string& component, const log::Log& log);

}  // namespace rubber_suspension::bag
