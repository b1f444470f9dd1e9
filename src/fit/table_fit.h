// Parameters of a component from a measured table of stiffness and loss angle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/master_curve.h"
#include "rubber_suspension/fit/measured_table.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::fit {

struct FittedParameter {
  std::string name;    ///< name such as "friction[1].maximum_force"
  double given = 0.0;  ///< value at which the fit began
  double value = 0.0;
  bool determined = true;  ///< false if at a bound, or if the standard deviation of its logarithm exceeds ln(2)/1.96
  double deviation = 0.0;  ///< standard deviation of its logarithm if the model is right; infinite if no row shows it
};

struct TableFit {
  io::ComponentDescription component;  ///< list of elements with the fitted values
  std::vector<FittedParameter> parameters;
  double misfit_before = 0.0;               ///< RMS of |K*_model - K*|/|K*| over the points, K* = K exp(i delta)
  double misfit = 0.0;                      ///< RMS after the fit
  std::optional<MasterCurve> master_curve;  ///< present if the table has temperatures
};

/// Fits the logarithms of the parameters by least squares of (K*_model - K*)/|K*| over all points, within a factor of
/// 10 or two standard deviations of the given values. Counts, tables, dead bands and reference quantities are kept. The
/// result is a local optimum, so `description` should be of about the right size. Rows of several temperatures are
/// first shifted onto one curve (masterCurve()) at the reference of the component, if any; the fitted component has the
/// law of the shifts. With a `series` the fit begins with its elements. Throws std::invalid_argument for fewer than two
/// points, points that are no loops, and a component without parameters that a table shows.
TableFit fitToTable(const io::ComponentDescription& description, const std::vector<TablePoint>& points,
                    std::optional<Series> series = std::nullopt);

}  // namespace rubber_suspension::fit
