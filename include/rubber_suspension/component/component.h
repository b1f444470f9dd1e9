// A component: elements in parallel, effects between actuator and test piece, and factors on the test piece's force.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "rubber_suspension/component/series_balance.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/kernel/basic_laws_kernel.h"

namespace rubber_suspension::component {

/// Memory of a component between two samples. Copy it to save it or to try a step. The data that a step needs are on
/// few cache lines.
class alignas(kernel::kCacheLine) ComponentState {
 public:
  double displacement() const { return displacement_; }  ///< displacement at the last sample [m]
  std::vector<double> memory() const { return {memory_.begin(), memory_.end()}; }
  bool isFinite() const {
    return std::all_of(memory_.begin(), memory_.end(), [](double number) { return std::isfinite(number); });
  }
  /// Saves the memory to a list. A list that is reused needs no allocation.
  void saveMemory(std::vector<double>& numbers) const { numbers.assign(memory_.begin(), memory_.end()); }

  /// Copies the memory of another state of the same component, but not the coefficients for its step length. This is
  /// faster than a full copy.
  void copyFrom(const ComponentState& other) {
    displacement_ = other.displacement_;
    prepared_.branch = other.prepared_.branch;
    std::copy(other.memory_.begin(), other.memory_.end(), memory_.begin());
  }

 private:
  friend class Component;

  // Working space for the solution of a series balance.
  struct Trial {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    std::vector<double> memory;     // memory of the test piece, which trial steps advance
    double slope_step = kNone;      // step length [s] for which `slope` is valid
    element::ComponentForce slope;  // force of the linear elements per metre of a step
    double displacement = kNone;    // displacement at the end of the last trial step [m]
    element::ComponentForce force;  // force at the end of the last trial step
  };

  double displacement_ = 0.0;
  bool kernel_alone_ = false;      // copy of the member of Component
  kernel::PreparedStep prepared_;  // derived and not saved; has a branch only for a component of the kernel alone
  // Memory of all elements, one after the other; mostly inline, on cache lines next to the coefficients.
  boost::container::small_vector<double, 16> memory_;
  Trial trial_;  // not part of the saved memory
};

/// Linearisation of one step about its end, for implicit integrators: dF/dz at the end of the step is stiffness +
/// damping/dt.
struct Tangent {
  double stiffness;  ///< derivative of elastic and friction force with respect to the final displacement [N/m]
  double damping;    ///< dt times the derivative of the viscous force [N s/m]
};

/// Computes the force F from the displacement z:
///   1. displacement path: a delay, then free play, then elements in series (compliances, contacts that open) determine
///   the displacement of the test piece;
///   2. test piece: F is the sum of the forces F_i of all elements in parallel;
///   3. softening and heating scale this force;
///   4. parts of the rig (inertia, offset, drift) depend on z itself, and their forces are added.
/// A component may have a shift with temperature. The elements of the test piece are then computed with the reduced
/// time dt/a_T, and their sum is multiplied by b_T before step 3. Without a temperature a_T = b_T = 1.
///
/// The order of the displacement path does not depend on the order of the entries. A delay belongs to a sensor, so it
/// comes first, and everything else uses the displacement at the time of the force. Free play comes before the
/// compliance, because it is specified, and visible in a log, as a range of displacement that moves nothing. The order
/// matters only if the test piece has a force at zero displacement, due to friction or relaxation.
///
/// Parameters are fixed at construction. All history is in ComponentState, so several threads may share a component.
class Component {
 public:
  /// Throws std::invalid_argument that states entry, parameter, value and what is accepted.
  explicit Component(const std::vector<element::ElementDescription>& elements);

  /// Returns a state of the right size, at rest at zero displacement.
  ComponentState makeState() const;

  /// Restores a state from its displacement() [m] and memory(). Throws std::invalid_argument, without changing the
  /// state, for a wrong size and for numbers that are not finite or that no element can have saved.
  void restore(ComponentState& state, double displacement, const std::vector<double>& memory) const;

  /// Initialises the component at rest at a displacement [m], fully relaxed and never loaded before.
  element::ComponentForce initialise(ComponentState& state, double displacement) const;

  /// Relaxes and cools the component by a long rest at a displacement [m]. Permanent changes (stress softening) remain.
  element::ComponentForce relax(ComponentState& state, double displacement) const;

  /// Advances by dt > 0 [s] to a displacement [m], with linear motion in between. Allocates nothing. All further forces
  /// are NaN once the test piece becomes unstable behind a series compliance, that is, if its tangent stiffness (for
  /// example of an asymmetric_stiffness) is more negative than the compliance can balance.
  __attribute__((always_inline)) element::ComponentForce step(ComponentState& state, double dt,
                                                              double displacement) const {
    if (!state.kernel_alone_) {
      return stepAlongPath(state, dt, displacement);
    }
    double* const memory = state.memory_.data();
    const double increment = displacement - state.displacement_;
    state.displacement_ = displacement;
    return state.prepared_.continues(dt, displacement, memory)
               ? state.prepared_.continueTo(displacement, increment, memory)
               : kernel_.step(dt, displacement, increment, memory, state.prepared_);
  }

  /// Returns true if the component depends on temperature.
  bool shiftsWithTemperature() const { return !shifts_.empty(); }

  /// Returns the temperatures [degC] at which all shifts of the component are valid.
  const element::Range& temperatures() const { return temperatures_; }

  /// Sets the temperature [degC] of the following steps and computes the factors, without changing the memory. Does
  /// nothing if the temperature is unchanged or the component has no shift. Throws std::invalid_argument outside of
  /// temperatures(); otherwise allocates nothing.
  void setTemperature(ComponentState& state, double temperature) const;

  /// Resets the factors to a_T = b_T = 1, as in makeState().
  void forgetTemperature(ComponentState& state) const;

  /// Simulates steps of dt [s] to `count` displacements [m] and writes the total forces [N] to `force`. The forces
  /// equal those of step() bit by bit, and are computed several times as fast. Allocates nothing.
  void simulate(ComponentState& state, double dt, const double* displacement, std::size_t count, double* force) const;

  /// Simulates as above, with a temperature [degC] for each step.
  void simulate(ComponentState& state, double dt, const double* displacement, const double* temperature,
                std::size_t count, double* force) const;

  /// Linearises the step of dt [s] from `state` to a displacement [m] about its end, by central differences of two
  /// trial steps that differ by 10 nm in either direction. The relative error is about 1e-7 for friction that reverses
  /// within 0.1 mm, and 1e-9 for linear laws. At a reversal, where friction has two slopes, the result is their mean.
  /// `trial` is working space from makeState(). Does not change `state` and allocates nothing.
  Tangent tangent(const ComponentState& state, double dt, double displacement, ComponentState& trial) const;

  /// Returns true if all elements are linear, so that complexStiffness() returns a value.
  bool linear() const;

  /// Returns the complex stiffness K* [N/m] at a frequency [Hz]; nullopt if an element is nonlinear.
  std::optional<std::complex<double>> complexStiffness(double frequency) const {
    return complexStiffnessShifted(frequency, {});
  }

  /// Returns K* at a frequency [Hz] and a temperature [degC]; the test piece contributes b_T K*(a_T omega). Throws like
  /// setTemperature().
  std::optional<std::complex<double>> complexStiffness(double frequency, double temperature) const {
    return complexStiffnessShifted(frequency, shiftAt(temperature));
  }

  /// Returns the entries from which the component was constructed, with defaults.
  const std::vector<element::ElementDescription>& elements() const { return descriptions_; }

 private:
  template <class Law>
  struct Placed {
    std::shared_ptr<const Law> law;
    std::size_t offset;  // index of the element's memory in the state
  };
  enum class Start { as_new, relaxed };
  enum TemperatureSlot { kTemperature, kRate /* 1/a_T */, kForce /* b_T */, kTemperatureSlots };

  bool acceptsMemory(const double* memory) const;
  void place(const std::shared_ptr<const element::ParallelElement>& law, element::BasicLaws& basic_laws);
  template <class Law>
  void placeMemory(std::vector<Placed<Law>>& placed);
  std::size_t reserve(std::size_t size);
  void reserveMemory();

  element::ComponentForce start(ComponentState& state, double displacement, Start kind) const;
  element::ComponentForce startTestPiece(double displacement, Start kind, double* memory) const;
  template <class Force>
  double solveSeries(Force force, double path, double before, double guess) const;
  double balanceAtStart(ComponentState& state, double displacement, Start kind) const;

  element::ComponentForce stepAlongPath(ComponentState& state, double dt, double displacement) const;
  template <class Count>
  void stepsAlongPath(ComponentState& state, double dt, const double* displacement, Count count,
                      element::ComponentForce* force) const;
  template <class Count>
  void applyDisplacementEffects(element::Motion* motion, Count count, double* memory) const;
  double balance(ComponentState& state, const element::Motion& path) const;
  template <class Count>
  void stepTestPiece(const kernel::PreparedStep& prepared, const element::Motion* motion, Count count, double* memory,
                     element::ComponentForce* force) const;
  template <class Count>
  void stepElements(const kernel::PreparedStep& prepared, const element::Motion* motion, Count count, double* memory,
                    element::ComponentForce* force) const;
  element::Shift shiftAt(double temperature) const;
  /// Returns the step in reduced time [s], which the elements use, for a step of dt [s].
  double reducedStep(double dt, const double* memory) const {
    return shifts_.empty() ? dt : dt * memory[temperature_slot_ + kRate];
  }
  std::optional<std::complex<double>> testPieceStiffness(double omega) const;
  std::optional<std::complex<double>> complexStiffnessShifted(double frequency, const element::Shift& shift) const;

  std::vector<element::ElementDescription> descriptions_;

  // The displacement path. The memory contains the displacement behind the effects and that of the test piece.
  std::vector<Placed<element::DisplacementEffect>> displacement_effects_;
  SeriesBalance series_;
  std::size_t behind_effects_slot_ = 0;
  std::size_t test_piece_slot_ = 0;

  kernel::BasicLawsKernel kernel_;                           // contains all laws of most components
  std::vector<Placed<element::ParallelElement>> elements_;   // all other laws, with the linear ones first
  std::ptrdiff_t linear_count_ = 0;                          // number of linear laws
  std::vector<Placed<element::ForceEffect>> force_effects_;  // effects that scale the sum of kernel_ and elements_

  std::vector<Placed<element::ParallelElement>> rig_;

  std::vector<std::shared_ptr<const element::TemperatureShift>> shifts_;
  element::Range temperatures_;  // temperatures at which all shifts are valid
  std::size_t temperature_slot_ = 0;

  bool kernel_alone_ = true;  // true if the component consists of the kernel alone
  // Order of the memory: kernel, other elements, force effects, and temperature with its factors, which are all that a
  // trial step of the series balance needs; then displacement effects, rig, and the two displacements.
  std::size_t memory_size_ = 0;
  std::size_t trial_size_ = 0;
};

}  // namespace rubber_suspension::component
