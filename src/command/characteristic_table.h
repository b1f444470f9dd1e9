// A component as laboratories and other programs describe one: dynamic stiffness and loss angle over frequency,
// amplitude and preload.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {

/// Grid of a table: every combination of these values.
struct TableGrid {
  std::vector<double> frequencies;     ///< [Hz]
  std::vector<double> amplitudes;      ///< [m]
  std::vector<double> preloads = {0};  ///< [N]
};

struct TableRow {
  double preload = 0.0;  ///< [N]
  double mean = 0.0;     ///< displacement at rest under the preload [m]
  response::SweepPoint point;

  /// First harmonic of the force over that of the displacement [N/m].
  std::complex<double> complex_stiffness;
};

struct CharacteristicTable {
  std::string component;
  std::vector<TableRow> rows;      ///< in the order of the grid; the frequency varies fastest, the preload slowest
  std::vector<std::string> notes;  ///< properties of the component that such a table cannot show
};

/// Computes a table, with a progress bar on a terminal. Throws std::invalid_argument for invalid frequencies and
/// amplitudes, and for preloads that the component does not reach within 1 m.
CharacteristicTable makeTable(const std::string& name, const component::Component& component, const TableGrid& grid);

/// Returns CSV with the columns frequency_Hz, amplitude_m, preload_N, mean_displacement_m, stiffness_N_per_m,
/// loss_angle_rad, storage_stiffness_N_per_m, loss_stiffness_N_per_m; numbers read back bit by bit.
std::string toCsv(const CharacteristicTable& table);

/// Returns the displacement [m] of a new, relaxed component at rest under a force [N], at most 1 m to either side.
double restingDisplacement(const component::Component& component, double force);

}  // namespace rubber_suspension::command
