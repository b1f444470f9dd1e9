// Describes a component as laboratories do: dynamic stiffness and loss angle over frequency, amplitude and preload.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {

/// The grid of a table, which contains every combination of these values.
struct TableGrid {
  std::vector<double> frequencies;     ///< [Hz]
  std::vector<double> amplitudes;      ///< [m]
  std::vector<double> preloads = {0};  ///< [N]
};

struct TableRow {
  double preload = 0.0;  ///< [N]
  double mean = 0.0;     ///< static displacement under the preload [m]
  response::SweepPoint point;

  /// First harmonic of the force divided by the first harmonic of the displacement [N/m].
  std::complex<double> complex_stiffness;
};

struct CharacteristicTable {
  std::string component;
  std::vector<TableRow> rows;      ///< frequencies vary fastest, preloads slowest
  std::vector<std::string> notes;  ///< notes on properties of the component that such a table cannot show
};

/// Computes a table and shows a progress bar on a terminal. Throws std::invalid_argument for invalid frequencies or
/// amplitudes, and for a preload that the component does not reach within a displacement of 1 m.
CharacteristicTable makeTable(const std::string& name, const component::Component& component, const TableGrid& grid);

/// Returns CSV with the columns frequency_Hz, amplitude_m, preload_N, mean_displacement_m, stiffness_N_per_m,
/// loss_angle_rad, storage_stiffness_N_per_m, loss_stiffness_N_per_m. Reading returns the same bits.
std::string toCsv(const CharacteristicTable& table);

/// Returns the displacement [m] at which a new component rests under a force [N]. Throws if it exceeds 1 m.
double restingDisplacement(const component::Component& component, double force);

}  // namespace rubber_suspension::command
