// Reads the node's topics in a ROS bag as a log, and writes a log as these topics. bag/bag_writer.h includes the
// headers of ROS, which take long to compile; this file does not.
#pragma once

#include <memory>
#include <string>

#include "rubber_suspension/component/rotation_measure.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::bag {

/// Reads displacement and, if recorded, measured force and temperature of one component from topics that end in
/// <component>/displacement, <component>/measured_force and <component>/temperature; an empty name selects the bag's
/// only component. The log has the stamps of the displacement. Forces are matched by stamp: `counts` is 0 where one is
/// missing, or comes at a lower rate; those of a clock of their own, which may drift against that of the displacement,
/// are interpolated linearly, with a note. Messages are sorted by stamp, with a note if one overtook another. If the
/// format names columns, they are fields of messages of any type (bag/message_field.h), in SI units or those of the
/// format, and displacement is one of them. Throws LogError that names bag, topic, message and reason; for stamps that
/// do not increase, also the option that reads them: a sampling rate, or the times of receipt.
log::Log readBagLog(const std::string& path, const std::string& component = "", const log::LogFormat& format = {});

/// Reads the poses of a component of six directions and, if recorded, measured wrenches and temperature from topics
/// that end in <component>/pose, <component>/measured_wrench and <component>/temperature, matched as by readBagLog(),
/// with rotations in `measure`. Throws LogError, also for stamps out of order and quaternions that the node would drop.
log::PoseLog readBagPoses(const std::string& path, const std::string& component, component::RotationMeasure measure);

/// Returns true for a file that ends in .bag or begins as a bag does.
bool isBagPath(const std::string& path);

/// Reads a log of any kind: a bag, else as log::readLog().
log::Log readAnyLog(const std::string& path, const std::string& component = "", const log::LogFormat& format = {});

/// Reads the logs of a file of any kind: the one of a bag, else as log::readLogs().
std::vector<log::Log> readAnyLogs(const std::string& path, const std::string& component, const log::LogFormat& format);

/// Opens logs to be read block by block, as log::openLogs(); a bag is kept in memory.
log::LogSources openAnyLogs(const std::string& path, const std::string& component, const log::LogFormat& format);

/// Writes displacement and any measured forces and temperatures, the latter where they change. Throws LogError.
void writeBagLog(const std::string& path, const std::string& component, const log::Log& log);

}  // namespace rubber_suspension::bag
