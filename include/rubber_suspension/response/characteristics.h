// Stiffness and loss angle of a force-displacement loop. Throws nothing.
#pragma once

#include <complex>

namespace rubber_suspension::response {

/// Properties of a component in one closed cycle.
struct Characteristics {
  double stiffness = 0.0;   ///< K = (F_max - F_min)/(z_max - z_min) [N/m], Polach (IAVSD 2015) Eq. 1
  double loss_angle = 0.0;  ///< arcsin(W/(pi/4 (F_max - F_min)(z_max - z_min))) [rad], Eq. 2
  double loss = 0.0;        ///< W, energy lost in the cycle: the area of the loop [J]
};

/// Returns the characteristics of the elliptic loop of a linear component with this K* at this amplitude [m]: K = |K*|,
/// sin(delta) = Im K*/|K*|.
Characteristics characteristicsOfEllipse(std::complex<double> complex_stiffness, double amplitude);

}  // namespace rubber_suspension::response
