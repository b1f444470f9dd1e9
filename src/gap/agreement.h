// Agreement of a simulated with a measured force over a log, by the figures that test laboratories use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/gap/iso18571.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::gap {

/// Agreement of two forces; for a moment, N and m mean N m and rad.
struct Agreement {
  double gap = 0.0;        ///< RMS of the difference over the standard deviation of the measured force [-]
  double rms = 0.0;        ///< of the difference [N]
  double peak = 0.0;       ///< largest difference [N]
  double peak_time = 0.0;  ///< of the largest difference, from the start of the log [s]
  std::optional<double> measured_energy;   ///< dissipated per cycle of the motion [J]; nullopt without a cycle
  std::optional<double> simulated_energy;  ///< likewise
  Iso18571 iso18571;                       ///< at even time steps; stretches between time gaps are joined

  /// Returns the error of the energy per cycle over the measured one [-]; nullopt if no energy was dissipated.
  std::optional<double> energyError() const;
};

/// Compares the measured force of a log with a simulated one, from the sample `first` on, where it was measured; for
/// energy and ISO 18571 it is interpolated elsewhere. Throws std::invalid_argument if the numbers of values differ,
/// fewer than two samples remain, a simulated force is too large, or the measured force does not change.
Agreement agreementOf(const log::Log& log, const std::vector<double>& simulated, std::size_t first = 0);

/// Limits of an agreement; those that are not set are not checked.
struct AgreementLimits {
  std::optional<double> gap;       ///< at most [-]
  std::optional<double> rms;       ///< at most [N]
  std::optional<double> peak;      ///< at most [N]
  std::optional<double> energy;    ///< of the error of the energy per cycle, at most [-]
  std::optional<double> iso18571;  ///< of the total, at least [-]
};

/// An agreement with its direction and limits.
struct ComparedForce {
  std::string direction;  ///< x to rz; empty for a component of one direction
  Agreement agreement;
  AgreementLimits limits;

  bool isMoment() const { return direction.size() == 2; }
};

/// Returns a table with a line for each figure, with its limit if there is one.
std::string agreementTable(const ComparedForce& compared);

/// Returns the figures beyond their limits in a phrase; empty if there are none.
std::string beyondLimits(const ComparedForce& compared);

/// Returns the figures of a log as JSON; those of six directions are below the names of the directions.
std::string agreementJson(const std::string& component, const std::string& log,
                          const std::vector<ComparedForce>& compared);

}  // namespace rubber_suspension::gap
