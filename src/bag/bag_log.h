// Logs in ROS bags: the node's topics as a log, and a log as the node's topics.
#pragma once

#include <ros/time.h>
#include <rosbag/bag.h>
#include <rubber_suspension/Gap.h>

#include <memory>
#include <string>

#include "log/new_file.h"
#include "rubber_suspension/element/element.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::bag {

/// Read displacement and, if recorded, measured force and temperature of one component from a bag: from topics that end
/// in <component>/displacement, <component>/measured_force and <component>/temperature; with an empty name the bag's
/// only component. Forces are matched by stamp; those whose stamps come from a clock of their own, which may drift
/// against that of the displacement, or at another rate, are interpolated linearly, with a note. A bag in which only a
/// part of the samples has a measured force gives the longest stretch in which all have one, with a note. Throws
/// LogError that names bag, topic, message and reason.
log::Log readBagLog(const std::string& path, const std::string& component = "");

/// True for a file that ends in .bag or begins as a bag does.
bool isBagPath(const std::string& path);

/// A log of any kind: a bag, else as log::readLog().
log::Log readAnyLog(const std::string& path, const std::string& component = "", const log::LogFormat& format = {});

/// The same to be read block by block: a bag is kept, else as log::openLog().
std::shared_ptr<const log::LogSource> openAnyLog(const std::string& path, const std::string& component,
                                                 const log::LogFormat& format);

/// The time that shifts a log's stamps into those that a ROS header can hold (0 to 2^32 s); 0 where none is needed
/// [ns].
std::int64_t headerShift(const log::Log& log);

/// A stamp in [ns] as ROS time. Throws LogError where a header cannot hold it.
ros::Time toRosTime(std::int64_t stamp);

/// Writes a component's samples to a bag, each at the time of its own stamp. The bag is written beside and takes its
/// name in close(), complete; without that call nothing is left. All calls throw LogError.
class BagWriter {
 public:
  BagWriter(const std::string& path, const std::string& component);
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  void writeDisplacement(std::int64_t stamp, double displacement);
  void writeMeasuredForce(std::int64_t stamp, double force);
  void writeTemperature(std::int64_t stamp, double temperature);
  void writeForce(std::int64_t stamp, double displacement, const element::ComponentForce& force);
  void writeGap(const Gap& gap);
  void close();

 private:
  template <class Message>
  void write(const std::string& topic, const Message& message);

  std::string path_;
  std::string component_;
  std::unique_ptr<log::NewFile> new_file_;
  rosbag::Bag bag_;
};

/// Write displacement and, if the log has them, measured force and temperature, where that changes. Throws LogError.
void writeBagLog(const std::string& path, const std::string& component, const log::Log& log);

}  // namespace rubber_suspension::bag
