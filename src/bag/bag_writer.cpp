// Writes the node's topics to a bag, sample by sample.
#include "bag/bag_writer.h"

#include <fmt/format.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/Force.h>
#include <rubber_suspension/MeasuredForce.h>
#include <sensor_msgs/Temperature.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "bag/bag_log.h"
#include "bag/header_stamp.h"
#include "log/samples.h"

namespace rubber_suspension::bag {
namespace {

// The exception of rosbag names the failing operation; errno may state the reason, such as a full disk.
[[noreturn]] void failToWrite(const std::string& path, const rosbag::BagException& error) {
  const std::string why = errno == ENOSPC || errno == EDQUOT || errno == EFBIG ? std::strerror(errno) : error.what();
  throw log::LogError(fmt::format("{}: cannot be written: {}", path, why));
}

}  // namespace

BagWriter::BagWriter(const std::string& path, const std::string& component)
    : path_(path), component_(component), file_(path), bag_(std::make_unique<rosbag::Bag>()) {
  try {
    bag_->open(file_.writingPath(), rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    abandon();
    failToWrite(path, error);
  }
}

BagWriter::~BagWriter() {
  try {
    bag_->close();  // errors do not matter, because the file is removed
  } catch (const std::exception&) {
    abandon();
  }
}

// Leaks the bag. On a full disk, its destructor would try to close it again and throw.
void BagWriter::abandon() { static_cast<void>(bag_.release()); }

template <class Message>
void BagWriter::write(const std::string& topic, const Message& message) {
  try {
    bag_->write("/" + component_ + topic, std::max(message.header.stamp, ros::TIME_MIN), message);
  } catch (const rosbag::BagException& error) {
    failToWrite(path_, error);
  }
}

void BagWriter::writeDisplacement(std::int64_t stamp, double displacement) {
  Displacement message;
  message.header.stamp = toRosTime(stamp);
  message.displacement = displacement;
  write("/displacement", message);
}

void BagWriter::writeMeasuredForce(std::int64_t stamp, double force) {
  MeasuredForce message;
  message.header.stamp = toRosTime(stamp);
  message.force = force;
  write("/measured_force", message);
}

void BagWriter::writeTemperature(std::int64_t stamp, double temperature) {
  sensor_msgs::Temperature message;
  message.header.stamp = toRosTime(stamp);
  message.temperature = temperature;
  write("/temperature", message);
}

void BagWriter::writeForce(std::int64_t stamp, double displacement, const element::ComponentForce& force) {
  Force message;
  message.header.stamp = toRosTime(stamp);
  message.displacement = displacement;
  message.force = force.total;
  message.elastic = force.elastic;
  message.viscous = force.viscous;
  message.friction = force.friction;
  write("/force", message);
}

void BagWriter::writeGap(const Gap& gap) { write("/gap", gap); }

void BagWriter::close() {
  try {
    bag_->close();
  } catch (const rosbag::BagException& error) {
    failToWrite(path_, error);
  }
  file_.commit();
}

void writeBagLog(const std::string& path, const std::string& component, const log::Log& log) {
  log::checkLog(log);
  BagWriter writer(path, component);
  const std::int64_t shift = headerShift(log);
  for (std::size_t i = 0; i < log.size(); ++i) {
    writer.writeDisplacement(log.stamp[i] + shift, log.displacement[i]);
    if (!log.force.empty() && log::isCounted(log, i)) {
      writer.writeMeasuredForce(log.stamp[i] + shift, log.force[i]);
    }
    if (!log.temperature.empty() && (i == 0 || log.temperature[i] != log.temperature[i - 1])) {
      writer.writeTemperature(log.stamp[i] + shift, log.temperature[i]);
    }
  }
  writer.close();
}

}  // namespace rubber_suspension::bag
