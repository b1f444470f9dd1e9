// Compares a simulated with a measured force over a log, with the criteria that test laboratories use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/gap/iso18571.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::gap {

/// Agreement of two forces. For a moment, N stands for N m and m for rad.
struct Agreement {
  double gap = 0.0;        ///< RMS of the difference, divided by the standard deviation of the measured force [-]
  double rms = 0.0;        ///< RMS of the difference [N]
  double peak = 0.0;       ///< largest difference [N]
  double peak_time = 0.0;  ///< time of the largest difference, from the start of the log [s]
  /// Measured energy that is dissipated per cycle of the motion [J]; nullopt if the log has no whole cycle.
  std::optional<double> measured_energy;
  std::optional<double> simulated_energy;
  Iso18571 iso18571;  ///< computed at even time steps; stretches between time gaps are joined

  /// Returns the relative error of the energy per cycle [-], or nullopt if no energy was dissipated.
  std::optional<double> energyError() const;
};

/// Compares the measured force of a log with a simulated one, from the sample `first` on. Samples without a measured
/// force are left out; for the energy and ISO 18571, their force is interpolated. Throws std::invalid_argument if the
/// numbers of values differ, fewer than two samples remain, a simulated force is too large, or the measured force
/// is constant.
Agreement agreementOf(const log::Log& log, const std::vector<double>& simulated, std::size_t first = 0);

/// Limits of an agreement. Limits that are not set are not checked.
struct AgreementLimits {
  std::optional<double> gap;       ///< upper limit [-]
  std::optional<double> rms;       ///< upper limit [N]
  std::optional<double> peak;      ///< upper limit [N]
  std::optional<double> energy;    ///< upper limit of the magnitude of energyError() [-]
  std::optional<double> iso18571;  ///< lower limit of the total rating [-]
};

struct ComparedForce {
  std::string direction;  ///< x to rz; empty for a component with one direction
  Agreement agreement;
  AgreementLimits limits;

  bool isMoment() const { return direction.size() == 2; }
};

/// Returns a table with one line per number, which also states the limit if there is one.
std::string agreementTable(const ComparedForce& compared);

/// Returns the numbers that are beyond their limits as a phrase, or an empty text if there are none.
std::string beyondLimits(const ComparedForce& compared);

/// Returns the agreement as JSON. If there are six directions, each has an object with its name.
std::string agreementJson(const std::string& component, const std::string& log,
                          const std::vector<ComparedForce>& compared);

}  // namespace rubber_suspension::gap
