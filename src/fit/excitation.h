// Frequencies and amplitudes that the logs have in common; candidates choose their grids by them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

struct Excitation {
  double largest_displacement = 0.0;  ///< largest |z| [m]
  double stiffness = 0.0;             ///< force over displacement, by their standard deviations [N/m]
  double force = 0.0;                 ///< standard deviation of the force [N]
  double lowest_force = 0.0;          ///< [N]; a thousandth of a log is beyond, as spikes are
  double highest_force = 0.0;         ///< likewise
  double power = 0.0;                 ///< mean of |force x rate| [W]
  double highest_frequency = 0.0;     ///< [Hz]
  double mean_frequency = 0.0;        ///< of the fastest log (Record::mean_frequency) [Hz]
  double highest_rate = 0.0;          ///< largest |dz/dt| [m/s]
  double longest_duration = 0.0;      ///< [s]
  double slowest_loop = 0.0;          ///< longest time that half the range of a log takes at its largest |dz/dt| [s]
  double dt = 0.0;                    ///< [s]
  /// Dead band [m] of laws that small reversals change permanently: larger than the noise of a constant displacement.
  double dead_band = 0.0;
  std::size_t whole_logs = 0;        ///< none of them an excerpt; 0 where there are excerpts
  gap::OwnErrors own;                ///< errors of the rig that any of them has for itself
  bool has_temperature = false;      ///< all logs have one
  double lowest_temperature = 0.0;   ///< [degC]
  double highest_temperature = 0.0;  ///< [degC]
  /// By which the temperatures shift, as superposition of what was measured tells [J/mol]; 0 where nothing does.
  double activation_energy = 0.0;
  /// Largest root of displacement squared and of that across squared [m]; 0 where the logs do not tell one from the
  /// other.
  double largest_radius = 0.0;
  double mass_bandwidth = 0.0;  ///< of the filter with which the node errs least by a mass [Hz]; 0: none
};

Excitation summarise(const std::vector<gap::PreparedRecord>& records);

/// Force of a mass of 1 kg that moves with the displacement [N], by central differences.
Eigen::VectorXd acceleration(const log::Record& record);

/// Bandwidth [Hz] with which an inertia that is driven by the displacement as recorded errs least; 0: none is needed.
double massBandwidth(const std::vector<gap::PreparedRecord>& records, double highest_frequency);

}  // namespace rubber_suspension::fit
