// A recorded log of six directions: poses of B in A and, where they were measured, wrenches.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// In SI units, by direction x, y, z, rx, ry, rz: coordinates [m, rad] of B in A in the component's rotation measure,
/// and the wrench on B at B's origin in A's axes [N, N m]. All vectors that are not empty have the same length.
struct PoseLog {
  using Quaternion = std::array<double, 4>;  ///< w, x, y, z

  std::string name;
  std::vector<std::int64_t> stamp;  ///< [ns]
  std::array<std::vector<double>, 6> coordinate;
  std::vector<Quaternion> quaternion;         ///< rotations of a bag, to the last bit; empty: those of the coordinates
  std::array<std::vector<double>, 6> wrench;  ///< empty if the log has none
  std::vector<double> temperature;            ///< [degC]; empty if the log has none
  std::vector<double> counts;                 ///< 0 where the wrench was not measured; empty: measured throughout
  std::vector<std::string> notes;
  UnitsAre units = UnitsAre::named;  ///< those of the least sure direction

  std::size_t size() const { return stamp.size(); }
};

/// Reads the columns x, y, z, rx, ry, rz and, where they are there, Fx, Fy, Fz, Mx, My, Mz, each with its unit behind
/// it (x_mm, rx_deg, Fx_N, Mz_Nm), from all that readLog() reads. Throws LogError as that does, where the columns are
/// leg lengths of a hexapod, and where a row lacks some of its values.
PoseLog readPoseLog(const std::string& path, const LogFormat& format = {});

/// Writes `time_s,x_m ... rz_rad,Fx_N ... Mz_Nm` with the coordinates of the log and other wrenches, one per sample;
/// all reads back bit by bit. Throws LogError.
void writeWrenchCsv(const std::string& path, const PoseLog& log, const std::array<std::vector<double>, 6>& wrench);

}  // namespace rubber_suspension::log
