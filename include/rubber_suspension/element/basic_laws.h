// Springs, dashpots, Maxwell elements and Berg friction as plain numbers, for code that steps many of them fast.
#pragma once

#include <vector>

namespace rubber_suspension::element {

/// The laws that most components are made of, in parallel. A law that is such a sum adds itself by addTo(). Throws
/// nothing.
struct BasicLaws {
  struct MaxwellNumbers {
    double stiffness;  ///< k [N/m]
    double rate;       ///< 1/tau [1/s]
  };
  struct FrictionNumbers {
    double maximum_force;  ///< F_max [N]
    double displacement;   ///< z2 [m]
    double dead_band;      ///< [m]
  };

  double stiffness = 0.0;  ///< of all springs [N/m]
  double damping = 0.0;    ///< of all dashpots [N s/m]
  std::vector<MaxwellNumbers> maxwells;
  std::vector<FrictionNumbers> frictions;  ///< of Berg
};

}  // namespace rubber_suspension::element
