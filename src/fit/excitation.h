// Ranges of motion and force over all logs, from which candidates choose their grids.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

struct Excitation {
  double largest_displacement = 0.0;  ///< largest |z| [m]
  double stiffness = 0.0;             ///< standard deviation of the force over that of the displacement [N/m]
  double force = 0.0;                 ///< standard deviation of the force [N]
  double lowest_force = 0.0;          ///< lowest force without the lowest 0.1 % of a log, which may be spikes [N]
  double highest_force = 0.0;         ///< highest force without the highest 0.1 % of a log [N]
  double power = 0.0;                 ///< mean of |force x rate| [W]
  double highest_frequency = 0.0;     ///< [Hz]
  double mean_frequency = 0.0;        ///< mean frequency of the fastest log (Record::mean_frequency) [Hz]
  double highest_rate = 0.0;          ///< largest |dz/dt| [m/s]
  double longest_duration = 0.0;      ///< [s]
  double slowest_loop = 0.0;          ///< longest time for half of a log's range at its largest |dz/dt| [s]
  double dt = 0.0;                    ///< [s]
  /// Dead band [m] for laws that small reversals change permanently: larger than the noise of a constant displacement.
  double dead_band = 0.0;
  std::size_t whole_logs = 0;        ///< number of logs; 0 if any is an excerpt
  gap::OwnErrors own;                ///< errors of the rig that are separate in at least one log
  bool has_temperature = false;      ///< true if all logs have a temperature
  double lowest_temperature = 0.0;   ///< [degC]
  double highest_temperature = 0.0;  ///< [degC]
  /// Activation energy of the shift with temperature, from the superposition of a table [J/mol]; 0 if unknown.
  double activation_energy = 0.0;
  /// Largest root of axial squared plus transverse displacement squared [m]; 0 if the transverse displacement is
  /// missing or follows the axial one.
  double largest_radius = 0.0;
  double mass_bandwidth = 0.0;  ///< massBandwidth() [Hz]
};

Excitation summarise(const std::vector<gap::PreparedRecord>& records);

/// Returns the force of a mass of 1 kg that moves with the displacement [N], by central differences.
Eigen::VectorXd acceleration(const log::Record& record);

/// Returns the filter bandwidth [Hz] with which an inertia on recorded displacement has the least error; 0 without
/// filter.
double massBandwidth(const std::vector<gap::PreparedRecord>& records, double highest_frequency);

}  // namespace rubber_suspension::fit
