// A recorded log of six directions: poses of B in A and, where they were measured, wrenches.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// A log in SI units by direction x, y, z, rx, ry, rz: coordinates [m, rad] of B in A in the component's rotation
/// measure, and the wrench on B at B's origin in A's axes [N, N m]. All vectors that are not empty have the same
/// length.
struct PoseLog {
  using Quaternion = std::array<double, 4>;  ///< w, x, y, z

  std::string name;
  std::vector<std::int64_t> stamp;  ///< [ns]
  std::array<std::vector<double>, 6> coordinate;
  std::vector<Quaternion> quaternion;         ///< rotations exactly as in a bag; empty: those of the coordinates
  std::array<std::vector<double>, 6> wrench;  ///< empty if the log has none
  std::vector<double> temperature;            ///< [degC]; empty if the log has none
  std::vector<double> counts;                 ///< 0 where the wrench was not measured; empty: measured throughout
  std::vector<std::string> notes;
  UnitsAre units = UnitsAre::named;  ///< named if they are in all directions

  std::size_t size() const { return stamp.size(); }
};

/// Reads the columns x, y, z, rx, ry, rz and, if present, Fx, Fy, Fz, Mx, My, Mz, each with its unit behind it (x_mm,
/// rx_deg, Fx_N, Mz_Nm), from every format that readLog() reads. Throws LogError as readLog() does, for leg lengths of
/// a hexapod, and if rows lack some of the directions.
PoseLog readPoseLog(const std::string& path, const LogFormat& format = {});

/// Writes `time_s,x_m ... rz_rad,Fx_N ... Mz_Nm` with the coordinates of the log and other wrenches, one per sample, so
/// that reading returns the same bits. Throws LogError.
void writeWrenchCsv(const std::string& path, const PoseLog& log, const std::array<std::vector<double>, 6>& wrench);

}  // namespace rubber_suspension::log
