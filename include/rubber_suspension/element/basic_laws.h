// Springs, dashpots, Maxwell elements and Berg friction as plain numbers, for code that steps many such laws fast.
#pragma once

#include <vector>

namespace rubber_suspension::element {

/// Contains the parameters of springs, dashpots, Maxwell elements and Berg friction that act in parallel in a
/// component. ParallelElement::addTo() adds the parameters of one law. Throws nothing.
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

  double stiffness = 0.0;  ///< sum over all springs [N/m]
  double damping = 0.0;    ///< sum over all dashpots [N s/m]
  std::vector<MaxwellNumbers> maxwells;
  std::vector<FrictionNumbers> frictions;  ///< Berg friction
};

}  // namespace rubber_suspension::element
