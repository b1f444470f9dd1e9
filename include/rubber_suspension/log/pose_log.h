// A recorded log in six directions: poses of frame B relative to frame A and, if they were measured, wrenches.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// A log in SI units. Arrays are indexed by direction: x, y, z, rx, ry, rz. The coordinates [m, rad] describe the pose
/// of B in A, with rotations in the component's rotation measure. The wrench [N, N m] acts on B at the origin of B and
/// is resolved in the axes of A. All vectors that are not empty have the same length.
struct PoseLog {
  using Quaternion = std::array<double, 4>;  ///< in the order w, x, y, z

  std::string name;
  std::vector<std::int64_t> stamp;  ///< [ns]
  std::array<std::vector<double>, 6> coordinate;
  std::vector<Quaternion> quaternion;         ///< rotations as stated in a bag; empty if the log has no quaternions
  std::array<std::vector<double>, 6> wrench;  ///< measured wrench; empty if the log has no wrench
  std::vector<double> temperature;            ///< temperature [degC]; empty if the log has no temperature
  std::vector<double> counts;                 ///< 0 where the wrench was not measured, otherwise 1; empty: 1 everywhere
  std::vector<std::string> notes;
  UnitsAre units = UnitsAre::named;  ///< `named` only if the units of all directions are named

  std::size_t size() const { return stamp.size(); }
};

/// Reads the columns x, y, z, rx, ry, rz and, if present, Fx, Fy, Fz, Mx, My, Mz from any format that readLog() reads.
/// Each name ends in its unit: x_mm, rx_deg, Fx_N, Mz_Nm. Throws LogError as readLog() does, and also for the leg
/// lengths of a hexapod and for rows in which only some directions have a value.
PoseLog readPoseLog(const std::string& path, const LogFormat& format = {});

/// Writes `time_s,x_m ... rz_rad,Fx_N ... Mz_Nm` with the coordinates of the log and the given wrenches, one per
/// sample. Reading returns the same bits. Throws LogError.
void writeWrenchCsv(const std::string& path, const PoseLog& log, const std::array<std::vector<double>, 6>& wrench);

}  // namespace rubber_suspension::log
