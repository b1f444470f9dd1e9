// The result of a simulation of the vehicle, sampled at a constant interval, and the difference of two results.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/io/figure.h"
#include "vehicle/bushes.h"

namespace rubber_suspension::vehicle {

struct History {
  std::vector<double> time;                   ///< [s]
  std::vector<std::vector<double>> position;  ///< coordinates of the vehicle [m, rad]
  std::vector<Poses> pose;
  std::vector<Wrenches> wrench;

  std::size_t size() const { return time.size(); }
};

/// Returns, per component, the RMS of the difference of the displacements divided by the RMS of the displacements of
/// `reference` [-]. Wrenches cannot be compared in this way, since a wrench that is held over a step represents the
/// middle of the step. Throws std::invalid_argument if the histories are empty or of different length.
PerBush<double> displacementDifference(const Bushes& components, const History& history, const History& reference);

/// Writes a CSV file. Its columns are time_s and, for struts, frame_m, pitch_rad, body_m, <component>_displacement_m
/// and <component>_force_N. For other kinds they are time_s and <component>_ followed by x_m to rz_rad and by Fx_N to
/// Mz_Nm. Throws std::runtime_error.
void writeHistoryCsv(const std::string& path, Kind kind, const Bushes& components, const History& history);

/// Returns a figure that shows the vertical displacements of a run, and their difference to a reference, over time.
io::Figure historyFigure(Kind kind, const Bushes& components, const History& history, const History& reference,
                         const std::string& title);

}  // namespace rubber_suspension::vehicle
