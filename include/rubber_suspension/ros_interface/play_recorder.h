// Records what a playback brought, pass by pass: forces and gap as CSV, all topics of the component as a bag.
#pragma once

#include <memory>
#include <string>

#include "rubber_suspension/io/log.h"
#include "rubber_suspension/ros_interface/bag_log.h"
#include "rubber_suspension/ros_interface/log_player.h"

namespace rubber_suspension {

/// Files to write; empty: not wanted.
struct RecordPaths {
  std::string forces;  ///< CSV: time_s,displacement_m,force_N
  std::string gaps;    ///< CSV: a row per message of COMPONENT/gap
  std::string bag;
};

/// The paths FOLDER/COMPONENT_force.csv, FOLDER/COMPONENT_gap.csv and FOLDER/COMPONENT.bag. A component may lie
/// in a ROS namespace: a slash in its name becomes an underscore.
RecordPaths recordPathsIn(const std::string& folder, const std::string& component);

/// Opens its files at once, so that what cannot be written is known before anything is played. All calls throw
/// LogError.
class PlayRecorder {
 public:
  PlayRecorder(const RecordPaths& paths, const std::string& component);

  /// Add the answered samples of a pass.
  void add(const Log& log, const PlayResult& result);
  void close();

 private:
  void addToBag(const Log& log, const PlayResult& result);
  void addGaps(const PlayResult& result);

  RecordPaths paths_;
  std::unique_ptr<LogCsvWriter> forces_;
  std::ofstream gaps_;
  std::unique_ptr<BagWriter> bag_;
};

}  // namespace rubber_suspension
