// Parameters of a component from a measured table of stiffness and loss angle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/master_curve.h"
#include "rubber_suspension/fit/measured_table.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::fit {

/// A parameter that the fit moved.
struct FittedParameter {
  std::string name;        ///< as "friction[1].maximum_force"
  double given = 0.0;      ///< what the fit began with
  double value = 0.0;      ///< what it ended with
  bool determined = true;  ///< false: at a bound, or a standard deviation of its logarithm above ln(2)/1.96
  double deviation = 0.0;  ///< standard deviation of its logarithm, if the model is right; inf where nothing shows it
};

struct TableFit {
  io::ComponentDescription component;  ///< as a list of elements, with the values found
  std::vector<FittedParameter> parameters;
  double misfit_before = 0.0;               ///< RMS of |K*_model - K*|/|K*| over the points, K* = K exp(i delta)
  double misfit = 0.0;                      ///< the same after the fit
  std::optional<MasterCurve> master_curve;  ///< of a table with temperatures
};

/// Least squares of (K*_model - K*)/|K*| over all points, in the logarithms of the parameters, each within a factor of
/// 10 of what is given; counts, tables, dead bands and reference quantities are kept. The result is a local optimum:
/// begin with a component of about the right size. Rows of several temperatures are first moved onto one curve
/// (masterCurve()), at the reference of the component where it has one; the component found shifts by its law. With a
/// `series` the fit begins with its elements in place of those given. Throws std::invalid_argument for fewer points
/// than two, for points that are no loops, and where the component has no parameter that a table shows.
TableFit fitToTable(const io::ComponentDescription& description, const std::vector<TablePoint>& points,
                    std::optional<Series> series = std::nullopt);

}  // namespace rubber_suspension::fit
