// State of a thixotropic structure, which motion breaks down and rest builds up. Throws nothing.
#pragma once

#include <cmath>

#include "rubber_suspension/element/element.h"

namespace rubber_suspension::element {

/// Solves dm/dt = (1 - m)/T_b - m |dz/dt|/s exactly over one step of constant velocity. m is the intact share of the
/// structure. Source: P. Haupt, K. Sedlan, Arch. Appl. Mech. 71 (2001) 89-109.
struct StructureState {
  double rate;     ///< 1/T_b + |dz/dt|/s [1/s]
  double settled;  ///< limit of m at this velocity [-]
  double decay;    ///< share of m - settled that remains after the step [-]

  /// A build-up time T_b [s] of 0 means no build-up. The travel s [m] must be greater than 0.
  StructureState(const Motion& motion, double build_up_time, double travel) {
    const double building = build_up_time > 0.0 ? 1.0 / build_up_time : 0.0;
    rate = building + std::abs(motion.increment) / (motion.dt * travel);
    settled = rate > 0.0 ? building / rate : 0.0;
    decay = std::exp(-rate * motion.dt);
  }

  double after(double state) const { return settled + (state - settled) * decay; }
};

}  // namespace rubber_suspension::element
