// Values of a sweep in the units of figures.
#pragma once

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {

constexpr double kDegrees = 180.0 / element::kPi;

/// [kN/mm]
inline double stiffnessOf(const response::SweepPoint& point) { return point.characteristics.stiffness * 1e-6; }

/// Loss angle [deg].
inline double angleOf(const response::SweepPoint& point) { return point.characteristics.loss_angle * kDegrees; }

}  // namespace rubber_suspension::command
