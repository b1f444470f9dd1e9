// A component: elements in parallel, what lies between actuator and specimen, and what scales the specimen's force.
#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/maxwell.h"
#include "rubber_suspension/kernel/maxwell_block.h"

namespace rubber_suspension::component {

/// Everything that a component remembers between two samples. Copying it is saving it; a trial step is a step on a
/// copy.
class ComponentState {
 public:
  double displacement() const { return displacement_; }  ///< at the last sample [m]
  const std::vector<double>& memory() const { return memory_; }

  /// Continue from numbers that memory() and displacement() gave. Throws std::invalid_argument on another size or on
  /// numbers that are not finite.
  void deserialise(double displacement, const std::vector<double>& memory);

  /// Take what another state of the same component remembers, and keep the coefficients of the step length last used;
  /// faster than copying all.
  void copyFrom(const ComponentState& other) {
    displacement_ = other.displacement_;
    branch_ = other.branch_;
    std::copy(other.memory_.begin(), other.memory_.end(), memory_.begin());
  }

 private:
  friend class Component;

  double displacement_ = 0.0;
  std::vector<double> memory_;   // of all elements, one block after the other
  std::vector<double> scratch_;  // trial memory of the series solve; derived, not saved
  // Coefficients of dashpot and Maxwell elements for the step length last used; derived, not saved.
  double prepared_dt_ = -1.0;
  double dashpot_gain_ = 0.0;  // c/dt [N/m]
  std::vector<kernel::MaxwellBlock> maxwell_blocks_;
  // Of the one element of friction that a component has beside springs, dashpots and Maxwell elements: the branch that
  // the memory describes, or none; derived, not saved.
  element::BergBranch branch_;
};

/// Linearisation of one step about its end, for an implicit integrator: dF/dz at the end of the step is
/// stiffness + damping/dt.
struct Tangent {
  double stiffness;  ///< derivative of the elastic and friction parts by the displacement at the end of the step [N/m]
  double damping;    ///< dt times that of the viscous part [N s/m]
};

/// Signal path: displacement -> delay, series mount, free play -> specimen (elements in parallel) -> softening, heating
/// -> plus what sits on the rig (inertia, offset, drift) -> force.
///
/// Parameters are fixed at construction; all history is in ComponentState, so one component may serve several threads.
class Component {
 public:
  /// Throws std::invalid_argument that names entry, parameter, value and what is accepted.
  explicit Component(const std::vector<element::ElementDescription>& elements);

  /// A state of the right size, at rest at zero displacement.
  ComponentState makeState() const;

  /// Put the component at rest at a displacement [m], relaxed since long and never loaded before.
  element::ComponentForce initialise(ComponentState& state, double displacement) const;

  /// The same component after a long rest at a displacement [m]: relaxed and cooled, what is permanent (stress
  /// softening) stays.
  element::ComponentForce relax(ComponentState& state, double displacement) const;

  /// Advance by dt > 0 [s] to a displacement [m], linear in between. Allocates nothing.
  /// The force is not a number, from there on, where the specimen has given way behind a series mount: where its
  /// tangent stiffness (of an asymmetric_stiffness, say) is more negative than the mount can hold.
  element::ComponentForce step(ComponentState& state, double dt, double displacement) const {
    return sameBits(dt, state.prepared_dt_) && keepsDirection(state, displacement) ? leanStep(state, displacement)
                                                                                   : fullStep(state, dt, displacement);
  }

  /// As many steps of dt [s] as there are displacements [m]; the total forces [N] go to `force`. The same bits as
  /// step() after step(), several times as fast. Allocates nothing.
  void simulate(ComponentState& state, double dt, const double* displacement, std::size_t count, double* force) const;

  /// Linearise the step of dt [s] from `state` to a displacement [m] about its end, by central differences of two trial
  /// steps 10 nm to either side (relative error about 1e-7 for friction that turns within 0.1 mm, 1e-9 for linear
  /// laws). At a reversal, where friction has two slopes, it is their mean. `trial` is working space from makeState().
  /// Neither `state` nor memory allocation is touched.
  Tangent tangent(const ComponentState& state, double dt, double displacement, ComponentState& trial) const;

  /// True if all elements are linear, so that complexStiffness has a value.
  bool linear() const;

  /// K* = dynamic stiffness at a frequency [Hz], [N/m]; nothing if an element is nonlinear.
  std::optional<std::complex<double>> complexStiffness(double frequency) const;

  /// The entries that the component was made of, defaults filled in.
  const std::vector<element::ElementDescription>& elements() const { return descriptions_; }

 private:
  template <class Law>
  struct Placed {
    std::shared_ptr<const Law> law;
    std::size_t offset;  // of its memory in the state
  };

  void placeMount(const std::shared_ptr<const element::SeriesElement>& mount);
  void placeSpecimen(const std::shared_ptr<const element::ParallelElement>& law);
  template <class Law>
  void placeAll(std::vector<Placed<Law>>& placed);
  std::size_t reserve(std::size_t size);
  void reserveMemory();
  void prepare(ComponentState& state, double dt) const;
  element::ComponentForce specimenRest(double displacement, bool as_new, double* memory) const;
  element::ComponentForce plainStep(const ComponentState& state, const element::Motion& motion, double* memory) const;
  element::ComponentForce fullStep(ComponentState& state, double dt, double displacement) const;

  static constexpr std::size_t kEffectBlock = 64;  // most steps at once through effects

  /// Steps through whatever there is, law after law, so that each finds what it needs at hand.
  void stepsThroughEffects(ComponentState& state, double dt, const double* displacement, std::size_t count,
                           element::ComponentForce* force) const;
  void specimenSteps(const ComponentState& state, const element::Motion* motion, std::size_t count, double* memory,
                     element::ComponentForce* force) const;
  void simulateEffects(ComponentState& state, double dt, const double* displacement, std::size_t count,
                       double* force) const;
  static void addSteps(const Placed<element::ParallelElement>& element, const element::Motion* motion,
                       std::size_t count, double* memory, element::ComponentForce* force);
  static void takeIncrements(element::Motion* motion, std::size_t count, double& last);
  element::ComponentForce settle(ComponentState& state, double displacement, bool as_new) const;
  /// A force that is linear in a displacement.
  struct Line {
    double held;   // [N]
    double slope;  // [N/m]
  };
  Line lineOf(const ComponentState& state) const;
  double forceAt(double specimen, Line line, const double* berg_memory) const;
  double solveSeriesBalance(Line line, double compliance, const ComponentState& state,
                            const element::Motion& motion) const;
  double complianceAt(double force) const;
  double mountDeflection(double force) const;
  double trialFriction(double specimen, const double* memory) const;
  double behindMountAtRest(ComponentState& state, double displacement, bool as_new) const;
  double behindMount(ComponentState& state, const element::Motion& motion) const;
  double plainBehindMount(const ComponentState& state, const element::Motion& motion) const;
  double plainBehindUnevenMount(const ComponentState& state, const element::Motion& motion) const;
  std::optional<std::complex<double>> specimenStiffness(double omega) const;

  /// Equality of step lengths, which are neither 0 nor NaN, as integers: that is two instructions less.
  static bool sameBits(double one, double other) {
    std::uint64_t bits = 0;
    std::uint64_t other_bits = 0;
    std::memcpy(&bits, &one, sizeof bits);
    std::memcpy(&other_bits, &other, sizeof other_bits);
    return bits == other_bits;
  }

  /// True where the step is that of springs, dashpots, Maxwell elements and friction that does not turn.
  bool keepsDirection(const ComponentState& state, double displacement) const {
    return frictionless_ || state.branch_.keepsDirection(displacement);
  }

  /// That step, for coefficients that are prepared. It calls nothing, so that all numbers stay in registers.
  element::ComponentForce leanStep(ComponentState& state, double displacement) const {
    const double increment = displacement - state.displacement_;
    state.displacement_ = displacement;
    double* memory = state.memory_.data();
    double friction = 0.0;
    if (!frictionless_) {
      memory[maxwells_ + element::BergFriction::kExtremum] = displacement;
      friction = state.branch_.follow(displacement);
    }
    const double viscous = viscousStep(state, increment, memory);
    return sumOf(displacement, viscous, friction);
  }

  /// With that of the springs [N].
  element::ComponentForce sumOf(double displacement, double viscous, double friction) const {
    const double elastic = spring_stiffness_ * displacement;
    return {elastic + viscous + friction, elastic, viscous, friction};
  }

  /// Advances all Maxwell elements; returns their force and that of the dashpots [N].
  double viscousStep(const ComponentState& state, double increment, double* memory) const {
    return kernel::stepMaxwells(state.maxwell_blocks_.data(), maxwells_, increment, state.dashpot_gain_ * increment,
                                memory);
  }

  std::vector<element::ElementDescription> descriptions_;
  std::size_t memory_size_ = 0;

  // The elements that most components consist of are kept as plain numbers and values, apart from the general ones.
  // Order of the memory: Maxwell forces, Berg friction, other elements of the specimen, force effects (all that a trial
  // step of the series solve changes), then displacement effects, rig, and the two displacements below.
  double spring_stiffness_ = 0.0;
  double dashpot_damping_ = 0.0;
  std::size_t maxwells_ = 0;
  std::vector<double> maxwell_stiffness_;  // [N/m], with zeros up to a whole number of blocks
  std::vector<double> maxwell_rate_;       // 1/tau [1/s], likewise
  double fastest_rate_ = 0.0;              // the largest of these
  std::vector<element::BergFriction> bergs_;

  std::vector<Placed<element::ParallelElement>> specimen_;
  std::vector<Placed<element::ParallelElement>> rig_;
  std::vector<Placed<element::DisplacementEffect>> displacement_effects_;
  std::vector<Placed<element::ForceEffect>> force_effects_;
  element::SeriesElement::Compliance mount_compliance_ = {
      0.0, 0.0};  // sums over the series mounts that are linear to a side
  std::vector<std::shared_ptr<const element::SeriesElement>> joints_;  // the others
  bool mounted_ = false;                                               // any of both
  bool mount_is_linear_ = true;                                        // alike to both sides, and none of the others
  bool plain_ = true;                    // nothing but springs, dashpots, Maxwell elements and Berg friction
  bool frictionless_ = true;             // the same without Berg friction
  std::size_t trial_size_ = 0;           // of the leading memory that a trial step changes
  std::size_t behind_effects_slot_ = 0;  // memory: displacement behind the displacement effects
  std::size_t behind_mount_slot_ = 0;    // memory: displacement of the specimen, behind the mount
};

}  // namespace rubber_suspension::component
