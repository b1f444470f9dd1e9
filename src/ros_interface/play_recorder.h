// Recorder of a playback. It writes the forces and the gap as CSV, and all topics of the component as a bag.
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

/// Files to write; an empty path means no file.
struct RecordPaths {
  std::string forces;  ///< CSV: time_s,displacement_m,force_N
  std::string gaps;    ///< CSV: a row per message of COMPONENT/gap
  std::string bag;
};

/// Returns the paths FOLDER/COMPONENT_force.csv, FOLDER/COMPONENT_gap.csv and FOLDER/COMPONENT.bag, where slashes of a
/// component's ROS namespace become underscores.
RecordPaths recordPathsIn(const std::string& folder, const std::string& component);

/// Records a playback pass by pass. The constructor opens the files, so that it throws before anything is played if
/// they cannot be written. close() gives the files their names. All functions throw std::runtime_error, such as
/// LogError.
class PlayRecorder {
 public:
  PlayRecorder(const RecordPaths& paths, const std::string& component);
  ~PlayRecorder();

  /// Adds a pass: answered samples and gaps to their CSV files, and all sent samples, answers and gaps to the bag.
  void add(const log::Log& log, const PlayResult& result);
  void close();

 private:
  void addToBag(const log::Log& log, const PlayResult& result);

  std::unique_ptr<log::LogCsvWriter> forces_;
  std::unique_ptr<log::NewFile> gaps_;
  std::unique_ptr<bag::BagWriter> bag_;
};

}  // namespace rubber_suspension::ros_interface
