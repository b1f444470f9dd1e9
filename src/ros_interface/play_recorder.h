// Records what a playback brought, pass by pass: forces and gap as CSV, all topics of the component as a bag.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "log/new_file.h"
#include "ros_interface/log_player.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::bag {
class BagWriter;
}

namespace rubber_suspension::ros_interface {

/// Files to write; empty: not wanted.
struct RecordPaths {
  std::string forces;  ///< CSV: time_s,displacement_m,force_N
  std::string gaps;    ///< CSV: a row per message of COMPONENT/gap
  std::string bag;
};

/// The paths FOLDER/COMPONENT_force.csv, FOLDER/COMPONENT_gap.csv and FOLDER/COMPONENT.bag. A component may lie
/// in a ROS namespace: a slash in its name becomes an underscore.
RecordPaths recordPathsIn(const std::string& folder, const std::string& component);

/// Opens its files at once, so that what cannot be written is known before anything is played; they take their names in
/// close(). All calls throw std::runtime_error, such as LogError.
class PlayRecorder {
 public:
  PlayRecorder(const RecordPaths& paths, const std::string& component);
  ~PlayRecorder();

  /// Add the answered samples of a pass.
  void add(const log::Log& log, const PlayResult& result);
  void close();

 private:
  void addToBag(const log::Log& log, const PlayResult& result);

  std::unique_ptr<log::LogCsvWriter> forces_;
  std::unique_ptr<log::NewFile> gaps_;
  std::unique_ptr<bag::BagWriter> bag_;
};

}  // namespace rubber_suspension::ros_interface
