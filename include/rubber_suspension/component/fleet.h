// Many components of one build side by side in vector instructions: all springs of a train at each tick, or one log for
// many sets of parameters.
#pragma once

#include <cstddef>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/kernel/instructions.h"

namespace rubber_suspension::component {

/// One number of each of eight components.
struct alignas(64) LaneRow {
  double lane[8];
};

struct FleetGroups;

/// Components that consist of springs, dashpots, Maxwell elements (as many in each) and at most one element of Berg
/// friction (in all or in none); parameters and displacements may all differ. Every force has the bits that
/// Component::step gives.
///
/// Parameters and state are kept here, eight components side by side, so that one instruction serves several: the
/// widest that the processor has (Instructions).
class ComponentFleet {
 public:
  /// At rest at zero displacement. Throws std::invalid_argument that says which component does not fit, and why.
  explicit ComponentFleet(const std::vector<component::Component>& components);

  std::size_t size() const { return size_; }

  /// All at rest at a displacement [m], relaxed since long.
  void initialise(double displacement);

  /// Advance all by dt > 0 [s], each to its displacement [m], linear in between; their total forces [N] go to `force`.
  /// Both have size() numbers and do not overlap. Allocates nothing.
  void step(double dt, const double* displacement, double* force);

  /// Advance all to the same displacement [m].
  void step(double dt, double displacement, double* force);

  /// One log for all: as many steps of dt [s] as there are displacements [m]. The force [N] of component k at sample i
  /// goes to force[i * size() + k]. Several times as fast as step() after step() where the components have one dead
  /// band, eight Maxwell elements at most, and have had the same displacements since they were at rest: reversals
  /// depend on the displacement alone, so that all of them turn at once. Allocates nothing.
  void simulate(double dt, const double* displacement, std::size_t count, double* force);

 private:
  /// What a component consists of.
  struct Laws {
    double spring_stiffness = 0.0;
    double damping = 0.0;
    std::vector<element::Maxwell> maxwells;
    std::vector<element::BergFriction> bergs;
  };

  static Laws lawsOf(const component::Component& component);
  bool frictional() const;
  void prepare(double dt);
  void stepEach(double dt, const double* displacement, double* force);
  void simulateBlock(const double* displacement, std::size_t count, double* force);
  FleetGroups groups(std::size_t first_lane, std::size_t lanes);
  LaneRow* group(std::size_t first_lane);
  double& number(std::size_t lane, std::size_t row);

  std::size_t size_;
  std::size_t maxwells_ = 0;          // of each component
  std::size_t rows_ = 0;              // of each group
  std::vector<Laws> laws_;            // of the lanes; those beyond size() repeat the last component
  std::vector<LaneRow> numbers_;      // group by group
  std::vector<double> displacement_;  // of the lanes, for one displacement of all
  double prepared_dt_ = -1.0;
  bool turn_together_ = false;  // where displacements are the same: one dead band
  bool moved_together_ = true;  // the same displacements since they were at rest
};

}  // namespace rubber_suspension::component
