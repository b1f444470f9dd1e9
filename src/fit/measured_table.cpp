// Checks of a table, and its gap.
#include "rubber_suspension/fit/measured_table.h"

#include <cmath>

#include "element/refuse.h"

namespace rubber_suspension::fit {

void checkPoints(const std::vector<TablePoint>& points) {
  element::refuseIf(points.size() < 2, "table: {} points are too few; accepted: at least 2 points", points.size());
  for (const TablePoint& point : points) {
    const bool good = point.frequency > 0.0 && point.amplitude > 0.0 && point.stiffness > 0.0 &&
                      std::isfinite(point.frequency + point.amplitude + point.stiffness + point.mean) &&
                      std::abs(point.loss_angle) < 1.6;
    element::refuseIf(!good,
                      "table: a point with {:g} Hz, {:g} m, {:g} N/m, {:g} rad about {:g} m is out of range; accepted: "
                      "frequency, amplitude and stiffness greater than 0, an angle below 90 degrees, all finite",
                      point.frequency, point.amplitude, point.stiffness, point.loss_angle, point.mean);
  }
}

double gapOfTable(const std::vector<TablePoint>& points, const std::vector<std::complex<double>>& model) {
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::complex<double> measured = points[i].complexStiffness();
    sum += std::norm((model[i] - measured) / std::abs(measured));
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace rubber_suspension::fit
