// The result of a simulation of the vehicle, at even times, and how two of them differ.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/six_directions.h"
#include "rubber_suspension/io/figure.h"
#include "vehicle/parameters.h"

namespace rubber_suspension::vehicle {

struct History {
  std::vector<double> time;           ///< [s]
  std::vector<Coordinates> position;  ///< [m, rad, m]
  std::vector<PerStrut> compression;  ///< [m]
  std::vector<PerStrut> force;        ///< [N]

  std::size_t size() const { return time.size(); }
};

/// The same with components of six directions.
struct BushedHistory {
  std::vector<double> time;                        ///< [s]
  std::vector<PerBush<Eigen::Isometry3d>> pose;    ///< of B in A [m]
  std::vector<PerBush<component::Wrench>> wrench;  ///< on B, in A's axes [N, N m]

  std::size_t size() const { return time.size(); }
};

/// RMS of the difference of the compressions over the RMS of those of `reference`, per component [-]: how differently
/// the vehicle has moved. (Forces that are held over a step are no measure: one at the start of a step stands for its
/// middle.) Throws std::invalid_argument where the two are not of the same length.
PerStrut displacementDifference(const History& history, const History& reference);

/// The same of the bushes' translations.
PerBush<double> displacementDifference(const PerBush<component::SixDirections>& components,
                                       const BushedHistory& history, const BushedHistory& reference);

/// Write time_s, frame_m, pitch_rad, body_m, <component>_displacement_m and <component>_force_N.
/// Throws std::runtime_error.
void writeHistoryCsv(const std::string& path, const History& history);

/// Write time_s and, behind the name of each component, the coordinates x_m to rz_rad and the wrench Fx_N to Mz_Nm.
/// Throws std::runtime_error.
void writeHistoryCsv(const std::string& path, const PerBush<std::string>& names,
                     const PerBush<component::SixDirections>& components, const BushedHistory& history);

/// The displacements of a run and their difference to a reference, over time.
io::Figure historyFigure(const History& history, const History& reference, const std::string& title);

}  // namespace rubber_suspension::vehicle
