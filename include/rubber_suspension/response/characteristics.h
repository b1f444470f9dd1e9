// Stiffness and loss angle of a force-displacement loop. Throws nothing.
#pragma once

#include <complex>

namespace rubber_suspension::response {

/// The stiffness and loss of a component in one closed cycle of displacement z and force F.
struct Characteristics {
  double stiffness = 0.0;   ///< K = (F_max - F_min)/(z_max - z_min) [N/m]; Polach (IAVSD 2015) Eq. 1
  double loss_angle = 0.0;  ///< delta = arcsin(W/(pi/4 (F_max - F_min)(z_max - z_min))) [rad], Eq. 2
  double loss = 0.0;        ///< W, energy lost in the cycle, which is the area of the loop [J]
};

/// Returns the characteristics of a linear component with complex stiffness K* at an amplitude [m]. The loop is an
/// ellipse with K = |K*| and sin(delta) = Im K*/|K*|.
Characteristics characteristicsOfEllipse(std::complex<double> complex_stiffness, double amplitude);

}  // namespace rubber_suspension::response
