// Stiffness and loss angle of a force-displacement loop.
#pragma once

#include <complex>
#include <vector>

namespace rubber_suspension::response {

/// What one closed cycle tells about a component.
struct Characteristics {
  double stiffness = 0.0;   ///< K = (F_max - F_min)/(z_max - z_min) [N/m], Polach (IAVSD 2015) Eq. 1
  double loss_angle = 0.0;  ///< arcsin(W/(pi/4 (F_max - F_min)(z_max - z_min))) [rad], Eq. 2
  double loss = 0.0;        ///< W, energy lost in the cycle: the area of the loop [J]
};

/// Of a loop given by samples, measured or simulated; the last sample is joined to the first.
///
/// Peaks are those of the samples and the area is that of the polygon: for n evenly spaced samples of a harmonic cycle
/// the area is low by the factor sin(2 pi/n)/(2 pi/n), and a peak between two samples by up to (pi/n)^2/2.
/// A loop that gives energy has a negative loss angle.
/// Throws std::invalid_argument for fewer than three samples, sizes that differ, numbers that are not finite, a
/// displacement that does not move, or an area that no loop within its own bounding box can have.
Characteristics characteristicsOfLoop(const std::vector<double>& displacement, const std::vector<double>& force);

/// Of the elliptic loop of a linear component with this K*, at this amplitude [m]: K = |K*|, sin(delta) = Im K*/|K*|.
Characteristics characteristicsOfEllipse(std::complex<double> complex_stiffness, double amplitude);

}  // namespace rubber_suspension::response
