// Computes stiffness and loss angle of an elliptic loop.
#include "rubber_suspension/response/characteristics.h"

#include <cmath>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::response {
Characteristics characteristicsOfEllipse(std::complex<double> complex_stiffness, double amplitude) {
  const double stiffness = std::abs(complex_stiffness);
  return {stiffness, std::asin(complex_stiffness.imag() / stiffness),
          element::kPi * complex_stiffness.imag() * amplitude * amplitude};
}

}  // namespace rubber_suspension::response
