// Writes the node's topics to a bag, sample by sample.
#pragma once

#include <rosbag/bag.h>
#include <rubber_suspension/Gap.h>

#include <cstdint>
#include <memory>
#include <string>

#include "log/new_file.h"
#include "rubber_suspension/element/element.h"

namespace rubber_suspension::bag {

/// Writes the samples of a component to a bag, each at the time of its stamp. The bag has a temporary name until
/// close() renames it. Without close(), the bag is removed. All functions throw LogError.
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

  void abandon();

  std::string path_;
  std::string component_;
  log::NewFile file_;
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace rubber_suspension::bag
