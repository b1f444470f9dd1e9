// Up to which step a loop with delayed forces stays stable: from theory, and by trying.
#pragma once

#include <array>
#include <vector>

#include "vehicle/simulation.h"

namespace rubber_suspension::vehicle {

/// Where the loop of vehicle and components would oscillate on, if all forces of the components were late by `delay`.
struct DelayMargin {
  double delay;      ///< T [s]
  double frequency;  ///< [Hz]
};

/// The smallest delay at which the vehicle does not come to rest: the smallest T > 0 for which
///     det(-w^2 M + i w C + exp(-i w T) sum_j b_j K*_j(w) b_j^T) = 0
/// has a real root w; M masses, C the vehicle's own dampers, b_j the direction of component j in the coordinates, small
/// pitch. For every w the eigenvalues x of (sum b K* b^T)^-1 (w^2 M - i w C) are what exp(-i w T) would have to be;
/// where one has magnitude 1, T = -arg(x)/w. [Nyquist's criterion; for a single mass on a single spring it is T = d/w
/// with d the loss angle at the w of resonance.] Throws std::invalid_argument that names a component that is not
/// linear, or where there is no such delay.
DelayMargin delayMargin(const VehicleParameters& parameters, const std::vector<component::Component>& components);

/// Rate at which a kicked vehicle on level track gains (above 0) or loses speed in a loop of a fixed step [ns] and a
/// whole number of steps of delay [1/s], measured over the second half of `duration` [s], once what decays fast is
/// gone.
double growthRate(const VehicleParameters& parameters, const std::vector<component::Component>& components,
                  std::int64_t step, int delay, double duration = 5.0);

/// The largest step [s] at which such a loop loses speed, found by bisection to 1 % around `guess` [s];
/// 0 where there is none above 1 us.
double largestStableStep(const VehicleParameters& parameters, const std::vector<component::Component>& components,
                         int delay, double guess);

}  // namespace rubber_suspension::vehicle
