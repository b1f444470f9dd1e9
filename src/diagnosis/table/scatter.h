// How far the rows of a table are from their own truth.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::diagnosis::table {

/// The noise of a row, RMS of |error of K*|/|K*|, and how it is known.
struct Scatter {
  double level = 0.0;
  std::string source;
};

/// One floor, by the first of these that there is: what the laboratory states; repeated rows; of a table with
/// temperatures what one curve leaves of it, each temperature shifted along both axes, since the rows of one
/// temperature share its error; what a polynomial in the logarithms of frequency and amplitude leaves of ln K*; 3 % at
/// most, since what is rough may be what no law
/// has; 1 %, as laboratories reach. What is estimated from few rows may be too low by chance: the level is the upper
/// end of its one-sided interval of 84 %, a standard error of the normal distribution.
Scatter scatterOf(const std::vector<fit::TablePoint>& points, std::optional<double> stated);

}  // namespace rubber_suspension::diagnosis::table
