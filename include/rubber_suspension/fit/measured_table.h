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
  double amplitude = 0.0;                            ///< half of the peak-to-peak displacement [m]
  double stiffness = 0.0;                            ///< [N/m]
  double loss_angle = 0.0;                           ///< [rad]
  double mean = 0.0;                                 ///< mean displacement under the preload [m]
  std::optional<double> temperature = std::nullopt;  ///< [degC]

  /// Returns K exp(i delta) [N/m].
  std::complex<double> complexStiffness() const { return std::polar(stiffness, loss_angle); }
};

/// The rows of a table and further statements of its file.
struct MeasuredTable {
  std::string name;
  std::vector<TablePoint> points;
  std::vector<std::string> notes;  ///< notes of the reader, for example on ignored columns
  /// RMS of |K*_measured - K*_true|/|K*| of a row, if the laboratory states this uncertainty.
  std::optional<double> uncertainty = std::nullopt;
  bool accept_units = false;  ///< true if the units of the stiffness are not checked
};

/// Throws std::invalid_argument for fewer than 2 points, or if a point is out of range; the text states the range.
void checkPoints(const std::vector<TablePoint>& points);

/// Returns the gap of a table: the RMS over its rows of |K*_model - K*|/|K*| [-]. Because a sine of amplitude A has the
/// force amplitude |K*| A, this is the RMS force difference over the RMS force, with equal weights of rows.
double gapOfTable(const std::vector<TablePoint>& points, const std::vector<std::complex<double>>& model);

}  // namespace rubber_suspension::fit
