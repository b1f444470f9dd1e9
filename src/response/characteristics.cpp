// Stiffness and loss angle of a force-displacement loop, Eqs. 1 and 2 of Polach (IAVSD 2015).
#include "rubber_suspension/response/characteristics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "response/extent.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::response {
namespace {

bool allFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

void checkLoop(const std::vector<double>& displacement, const std::vector<double>& force) {
  if (displacement.size() != force.size()) {
    throw std::invalid_argument(fmt::format("loop: {} displacements but {} forces", displacement.size(), force.size()));
  }
  if (displacement.size() < 3) {
    throw std::invalid_argument(fmt::format("loop: {} samples, at least 3 are needed", displacement.size()));
  }
  if (!allFinite(displacement) || !allFinite(force)) {
    throw std::invalid_argument("loop: a sample is not finite");
  }
}

// Integral of F dz around the polygon, about its first corner so that offsets do not cancel digits.
double polygonArea(const std::vector<double>& displacement, const std::vector<double>& force) {
  double twice = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const std::size_t next = i + 1 < force.size() ? i + 1 : 0;
    twice += (force[i] + force[next] - 2.0 * force[0]) * (displacement[next] - displacement[i]);
  }
  return 0.5 * twice;
}

}  // namespace

Characteristics characteristicsOfLoop(const std::vector<double>& displacement, const std::vector<double>& force) {
  checkLoop(displacement, force);
  const double way = extent(displacement);
  const double range = extent(force);
  if (way == 0.0 || range == 0.0) {
    throw std::invalid_argument(fmt::format("loop: {} does not change", way == 0.0 ? "displacement" : "force"));
  }
  const double loss = polygonArea(displacement, force);
  const double sine = loss / (0.25 * element::kPi * range * way);
  if (std::abs(sine) > 1.0) {
    throw std::invalid_argument(
        fmt::format("loop: its area is {:.4g} times that of the ellipse in its bounding box, so it has no loss angle; "
                    "accepted: one "
                    "closed cycle, friction less angular than Coulomb's",
                    std::abs(sine)));
  }
  return {range / way, std::asin(sine), loss};
}

Characteristics characteristicsOfEllipse(std::complex<double> complex_stiffness, double amplitude) {
  const double stiffness = std::abs(complex_stiffness);
  return {stiffness, std::asin(complex_stiffness.imag() / stiffness),
          element::kPi * complex_stiffness.imag() * amplitude * amplitude};
}

}  // namespace rubber_suspension::response
