// Many components of one build at each tick, side by side in vector instructions: all springs of a train, or one spring
// with many sets of parameters.
#pragma once

#include <cstddef>
#include <vector>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension {

/// Components that consist of springs, dashpots, Maxwell elements (as many in each) and at most one element of Berg
/// friction (in all or in none); parameters and displacements may all differ. Every force has the bits that
/// Component::step gives.
///
/// Parameters and state are kept here, eight components side by side, so that one instruction serves several. Runs on
/// any processor and takes the wider instructions (AVX2) where there are some.
class ComponentFleet {
 public:
  /// At rest at zero displacement. Throws std::invalid_argument that says which component does not fit, and why.
  explicit ComponentFleet(const std::vector<Component>& components);

  std::size_t size() const { return size_; }

  /// All at rest at a displacement [m], relaxed since long.
  void rest(double displacement);

  /// Advance all by dt > 0 [s], each to its displacement [m], linear in between; their total forces [N] go to `force`.
  /// Both have size() numbers and do not overlap. Allocates nothing.
  void step(double dt, const double* displacement, double* force);

  /// Advance all to the same displacement [m].
  void step(double dt, double displacement, double* force);

 private:
  /// What a component consists of.
  struct Laws {
    double spring_stiffness = 0.0;
    double damping = 0.0;
    std::vector<Maxwell> maxwells;
    std::vector<BergFriction> bergs;
  };

  static Laws lawsOf(const Component& component);
  void prepare(double dt);
  double& number(std::size_t lane, std::size_t row);

  std::size_t size_;
  std::size_t maxwells_ = 0;  // of each component
  std::size_t rows_ = 0;      // of each group
  std::vector<Laws> laws_;    // of the lanes; those beyond size() repeat the last component
  std::vector<BergFriction> bergs_;
  std::vector<double> numbers_;       // group by group, row by row, one number for each lane
  std::vector<double> displacement_;  // of the lanes, for one displacement of all
  double prepared_dt_ = -1.0;
};

}  // namespace rubber_suspension
