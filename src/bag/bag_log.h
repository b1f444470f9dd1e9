// Logs in ROS bags: the node's topics as a log, and a log as the node's topics. Without ROS's own headers, which take
// long to compile: see bag/bag_writer.h.
#pragma once

#include <memory>
#include <string>

#include "rubber_suspension/component/rotation_measure.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::bag {

/// Read displacement and, if recorded, measured force and temperature of one component from a bag: from topics that end
/// in <component>/displacement, <component>/measured_force and <component>/temperature; with an empty name the bag's
/// only component. The stamps of the displacement are those of the log. Forces are matched by stamp: where one is
/// missing, or comes at a lower rate, `counts` is 0; those of a clock of their own, which may drift against that of the
/// displacement, are interpolated linearly, with a note. Messages are taken by their stamps, with a note where one
/// overtook another. Stamps that do not increase are refused with the option that reads them: the format's rate in
/// their place, or the time of receipt. Where the format names columns, they are fields of messages of any type
/// (bag/message_field.h), in SI units or those of the format, and displacement is one of them. Throws LogError that
/// names bag, topic, message and reason.
log::Log readBagLog(const std::string& path, const std::string& component = "", const log::LogFormat& format = {});

/// Read the poses of a component of six directions and, if recorded, measured wrenches and temperature: from topics
/// that end in <component>/pose, <component>/measured_wrench and <component>/temperature, matched and refused as those
/// of readBagLog(). The rotation is in this measure. Throws LogError, also for a quaternion that the node would drop.
log::PoseLog readBagPoses(const std::string& path, const std::string& component, component::RotationMeasure measure);

/// True for a file that ends in .bag or begins as a bag does.
bool isBagPath(const std::string& path);

/// A log of any kind: a bag, else as log::readLog().
log::Log readAnyLog(const std::string& path, const std::string& component = "", const log::LogFormat& format = {});

/// The logs of a file of any kind: that of a bag, else as log::readLogs().
std::vector<log::Log> readAnyLogs(const std::string& path, const std::string& component, const log::LogFormat& format);

/// Opens logs to be read block by block, as log::openLogs(); a bag is kept in memory.
log::LogSources openAnyLogs(const std::string& path, const std::string& component, const log::LogFormat& format);

/// Write displacement and, if the log has them, measured force and temperature, where that changes. Throws LogError.
void writeBagLog(const std::string& path, const std::string& component, const log::Log& log);

}  // namespace rubber_suspension::bag
