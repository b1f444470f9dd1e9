// Reads logs of six directions. Each direction is read like a log of its own; all must have the same stamps.
#include "rubber_suspension/log/pose_log.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "log/log_columns.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

constexpr std::array<const char*, 6> kCoordinates = {"x", "y", "z", "rx", "ry", "rz"};
constexpr std::array<const char*, 6> kWrench = {"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
constexpr std::size_t kRotations = 3;  // index of the first rotation

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Log readDirection(const std::string& path, LogFormat format, std::size_t direction, bool with_wrench) {
  format.turns = direction >= kRotations;
  format.of[static_cast<std::size_t>(Quantity::displacement)].column = kCoordinates[direction];
  format.of[static_cast<std::size_t>(Quantity::force)].column = with_wrench ? kWrench[direction] : "";
  return readLog(path, format);
}

[[noreturn]] void refuseColumns(const LogError& error) {
  const std::string text = error.what();
  for (const char* word : {"leg", "strut", "actuator", "bein"}) {
    if (contains(text, "no column") && contains(lowerCase(text), word)) {
      throw LogError(text +
                     "; the leg lengths of a hexapod are not a pose; accepted: x, y, z, rx, ry, rz with their units");
    }
  }
  throw LogError(text + "; accepted for six directions: x_mm, y_mm, z_mm, rx_deg, ry_deg, rz_deg, or with other units");
}

// Reads the first direction. Sets `with_wrench` to whether the log has wrenches.
Log readFirst(const std::string& path, const LogFormat& format, bool& with_wrench) {
  try {
    with_wrench = true;
    return readDirection(path, format, 0, true);
  } catch (const LogError& error) {
    if (!contains(error.what(), "no column 'Fx'")) {
      refuseColumns(error);
    }
  }
  with_wrench = false;
  Log log = readDirection(path, format, 0, false);
  if (!log.force.empty()) {
    throw LogError(fmt::format("{}: there is a force, but no column 'Fx'; accepted: all of {}, or none", path,
                               fmt::join(kWrench, ", ")));
  }
  return log;
}

}  // namespace

PoseLog readPoseLog(const std::string& path, const LogFormat& format) {
  PoseLog poses;
  bool with_wrench = false;
  for (std::size_t direction = 0; direction < kCoordinates.size(); ++direction) {
    Log log = direction == 0 ? readFirst(path, format, with_wrench) : [&] {
      try {
        return readDirection(path, format, direction, with_wrench);
      } catch (const LogError& error) {
        refuseColumns(error);
      }
    }();
    if (direction == 0) {
      poses.name = log.name;
      poses.stamp = std::move(log.stamp);
      poses.counts = std::move(log.counts);
      poses.temperature = std::move(log.temperature);
      std::copy_if(log.notes.begin(), log.notes.end(), std::back_inserter(poses.notes), [](const std::string& note) {
        return !contains(note, " is ignored") && !contains(note, " ignored");
      });
    } else if (log.stamp != poses.stamp) {
      throw LogError(fmt::format("{}: {} and {} have numbers in different rows; accepted: rows with all six directions",
                                 path, kCoordinates[0], kCoordinates[direction]));
    }
    poses.units = log.units == UnitsAre::named ? poses.units : log.units;
    poses.coordinate[direction] = std::move(log.displacement);
    poses.wrench[direction] = std::move(log.force);
  }
  return poses;
}

}  // namespace rubber_suspension::log
