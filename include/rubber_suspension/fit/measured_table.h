// A measured table of stiffness and loss angle.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::fit {

/// One measured sine: dynamic stiffness and loss angle of its settled loop (Polach, IAVSD 2015, Eqs. 1 and 2).
struct TablePoint {
  double frequency = 0.0;                            ///< [Hz]
  double amplitude = 0.0;                            ///< half of peak to peak [m]
  double stiffness = 0.0;                            ///< [N/m]
  double loss_angle = 0.0;                           ///< [rad]
  double mean = 0.0;                                 ///< mean displacement under the preload [m]
  std::optional<double> temperature = std::nullopt;  ///< [degC]

  /// Returns K exp(i delta) [N/m].
  std::complex<double> complexStiffness() const { return std::polar(stiffness, loss_angle); }
};

/// The rows of a table and what its file states about them.
struct MeasuredTable {
  std::string name;
  std::vector<TablePoint> points;
  std::vector<std::string> notes;  ///< of the reader, such as columns that were ignored
  /// Standard deviation of a row's K*, RMS of |K*_measured - K*_true|/|K*|, where the laboratory states it.
  std::optional<double> uncertainty = std::nullopt;
  bool accept_units = false;  ///< the units of its stiffness are not checked
};

/// Throws std::invalid_argument for fewer than 2 points, or for a point out of range, with its numbers and the range.
void checkPoints(const std::vector<TablePoint>& points);

/// Returns the gap of a table: RMS over its rows of |K*_model - K*|/|K*| [-]. A sine of K* and amplitude A has the
/// force K* A, so this is the RMS of the force difference over that of the force, with equal weights of the rows.
double gapOfTable(const std::vector<TablePoint>& points, const std::vector<std::complex<double>>& model);

}  // namespace rubber_suspension::fit
