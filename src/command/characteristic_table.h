// A component as laboratories and other programs describe one: dynamic stiffness and loss angle over frequency,
// amplitude and preload.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {

/// Where the characteristics are wanted: every combination of these.
struct TableGrid {
  std::vector<double> frequencies;     ///< [Hz]
  std::vector<double> amplitudes;      ///< [m]
  std::vector<double> preloads = {0};  ///< [N]
};

struct TableRow {
  double preload = 0.0;  ///< [N]
  double mean = 0.0;     ///< displacement that the preload leads to after a long rest [m]
  response::SweepPoint point;

  /// First harmonic of the force over that of the displacement [N/m].
  std::complex<double> complex_stiffness;
};

struct CharacteristicTable {
  std::string component;
  std::vector<TableRow> rows;      ///< preload by preload, amplitude by amplitude, with the frequency rising
  std::vector<std::string> notes;  ///< what of the component such a table cannot say
};

/// With a progress bar on a terminal. Throws std::invalid_argument for frequencies and amplitudes that make no loop,
/// and for preloads that the component does not carry within 1 m.
CharacteristicTable makeTable(const std::string& name, const component::Component& component, const TableGrid& grid);

/// Columns frequency_Hz, amplitude_m, preload_N, mean_displacement_m, stiffness_N_per_m, loss_angle_rad,
/// storage_stiffness_N_per_m, loss_stiffness_N_per_m; numbers that read back bit by bit.
std::string toCsv(const CharacteristicTable& table);

/// Displacement [m] at which the component rests, new and relaxed, under a force [N].
double restingDisplacement(const component::Component& component, double force);

}  // namespace rubber_suspension::command
