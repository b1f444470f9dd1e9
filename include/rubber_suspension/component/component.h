// A component: parallel elements, effects between actuator and test piece, and factors on the test piece's force.
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

/// Memory of a component between two samples. Copy it to save it or to try a step. The data of a step are on few cache
/// lines.
class alignas(kernel::kCacheLine) ComponentState {
 public:
  double displacement() const { return displacement_; }  ///< at the last sample [m]
  std::vector<double> memory() const { return {memory_.begin(), memory_.end()}; }
  bool isFinite() const {
    return std::all_of(memory_.begin(), memory_.end(), [](double number) { return std::isfinite(number); });
  }
  /// Saves the memory into a list that is reused, so that saving allocates nothing.
  void saveMemory(std::vector<double>& numbers) const { numbers.assign(memory_.begin(), memory_.end()); }

  /// Copies the memory of another state of the same component, but not its coefficients of the step length; faster than
  /// copying all.
  void copyFrom(const ComponentState& other) {
    displacement_ = other.displacement_;
    prepared_.branch = other.prepared_.branch;
    std::copy(other.memory_.begin(), other.memory_.end(), memory_.begin());
  }

 private:
  friend class Component;

  // Working space while a series balance is solved.
  struct Trial {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    std::vector<double> memory;     // of the test piece, which trial steps advance
    double slope_step = kNone;      // [s], of `slope`
    element::ComponentForce slope;  // force that a step of the linear elements adds for each metre
    double displacement = kNone;    // at the end of the last trial step [m]
    element::ComponentForce force;  // there
  };

  double displacement_ = 0.0;
  bool kernel_alone_ = false;      // as in the component
  kernel::PreparedStep prepared_;  // derived, not saved; a branch only if the component is the kernel alone
  // Memory of all elements, block after block; inline for most components, on cache lines next to the coefficients.
  boost::container::small_vector<double, 16> memory_;
  Trial trial_;  // not saved
};

/// Linearisation of one step about its end, for an implicit integrator: dF/dz at the end of the step is
/// stiffness + damping/dt.
struct Tangent {
  double stiffness;  ///< derivative of the elastic and friction parts by the displacement at the end of the step [N/m]
  double damping;    ///< dt times that of the viscous part [N s/m]
};

/// Displacement z -> force F:
///   1. displacement path: delay, then free play, then what is in series (compliance, contacts that open), give the
///      displacement of the test piece;
///   2. test piece: F = sum of F_i over the elements in parallel;
///   3. softening and heating scale this force;
///   4. parts of the rig (inertia, offset, drift) follow z itself and add to F.
/// If the component has a shift with temperature, the elements of the test piece run on the reduced time dt/a_T and
/// their sum is multiplied by b_T, before softening and heating. Without a temperature a_T = b_T = 1.
///
/// The order of the path does not depend on that of the entries. A delay is that of a sensor, so it comes first and all
/// else has the displacement at the time of the force. Free play comes before the compliance: it is specified, and
/// visible in a log, as a range of displacement that moves nothing, whatever the force of the test piece. The two
/// commute if the test piece has no force at zero displacement, but not if friction or relaxation leave a force there.
///
/// Parameters are fixed at construction; all history is in ComponentState, so one component may serve several threads.
class Component {
 public:
  /// Throws std::invalid_argument that names entry, parameter, value and what is accepted.
  explicit Component(const std::vector<element::ElementDescription>& elements);

  /// Returns a state of the right size, at rest at zero displacement.
  ComponentState makeState() const;

  /// Restores a state from its displacement() [m] and memory(). Throws std::invalid_argument, without changing the
  /// state, for a wrong size, numbers that are not finite, and those that no element can have written.
  void restore(ComponentState& state, double displacement, const std::vector<double>& memory) const;

  /// Initialises the component at rest at a displacement [m], fully relaxed and never loaded before.
  element::ComponentForce initialise(ComponentState& state, double displacement) const;

  /// Relaxes and cools the component by a long rest at a displacement [m]; permanent changes (stress softening) remain.
  element::ComponentForce relax(ComponentState& state, double displacement) const;

  /// Advances by dt > 0 [s] to a displacement [m], linear in between. Allocates nothing. The force is NaN, from there
  /// on, if the test piece becomes unstable behind a series compliance: if its tangent stiffness (of an
  /// asymmetric_stiffness, say) is more negative than the compliance can balance.
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

  /// Returns the temperatures [degC] at which its shifts are valid.
  const element::Range& temperatures() const { return temperatures_; }

  /// Sets the temperature [degC] of the following steps and computes the factors; the memory does not change. Without
  /// effect if the temperature is the same or the component has no shift. Throws std::invalid_argument outside of
  /// temperatures(); otherwise allocates nothing.
  void setTemperature(ComponentState& state, double temperature) const;

  /// Resets to a_T = b_T = 1, as in makeState().
  void forgetTemperature(ComponentState& state) const;

  /// Simulates steps of dt [s] to `count` displacements [m] and writes the total forces [N] to `force`: the same bits
  /// as step(), several times as fast. Allocates nothing.
  void simulate(ComponentState& state, double dt, const double* displacement, std::size_t count, double* force) const;

  /// Simulates with the temperature [degC] of each step.
  void simulate(ComponentState& state, double dt, const double* displacement, const double* temperature,
                std::size_t count, double* force) const;

  /// Linearises the step of dt [s] from `state` to a displacement [m] about its end, by central differences of two
  /// trial steps 10 nm to either side (relative error about 1e-7 for friction that reverses within 0.1 mm, 1e-9 for
  /// linear laws). At a reversal, where friction has two slopes, it is their mean. `trial` is working space from
  /// makeState(). Does not change `state` and allocates nothing.
  Tangent tangent(const ComponentState& state, double dt, double displacement, ComponentState& trial) const;

  /// Returns true if all elements are linear, so that complexStiffness has a value.
  bool linear() const;

  /// Returns K*, the dynamic stiffness [N/m] at a frequency [Hz]; nullopt if an element is nonlinear.
  std::optional<std::complex<double>> complexStiffness(double frequency) const {
    return complexStiffnessShifted(frequency, {});
  }

  /// Returns K* at a frequency [Hz] and a temperature [degC]: that of the test piece is b_T K*(a_T omega). Throws as
  /// setTemperature() does.
  std::optional<std::complex<double>> complexStiffness(double frequency, double temperature) const {
    return complexStiffnessShifted(frequency, shiftAt(temperature));
  }

  /// Returns the entries of which the component was made, with defaults.
  const std::vector<element::ElementDescription>& elements() const { return descriptions_; }

 private:
  template <class Law>
  struct Placed {
    std::shared_ptr<const Law> law;
    std::size_t offset;  // of its memory in the state
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
  /// Returns the step of the elements in reduced time [s] for a step of dt [s].
  double reducedStep(double dt, const double* memory) const {
    return shifts_.empty() ? dt : dt * memory[temperature_slot_ + kRate];
  }
  std::optional<std::complex<double>> testPieceStiffness(double omega) const;
  std::optional<std::complex<double>> complexStiffnessShifted(double frequency, const element::Shift& shift) const;

  std::vector<element::ElementDescription> descriptions_;

  // The displacement path, whose two displacements are in the memory.
  std::vector<Placed<element::DisplacementEffect>> displacement_effects_;
  SeriesBalance series_;
  std::size_t behind_effects_slot_ = 0;
  std::size_t test_piece_slot_ = 0;

  // The test piece.
  kernel::BasicLawsKernel kernel_;                           // all laws of most components
  std::vector<Placed<element::ParallelElement>> elements_;   // all others, the linear ones first
  std::ptrdiff_t linear_count_ = 0;                          // of the linear ones
  std::vector<Placed<element::ForceEffect>> force_effects_;  // which scale the sum of both

  std::vector<Placed<element::ParallelElement>> rig_;

  std::vector<std::shared_ptr<const element::TemperatureShift>> shifts_;
  element::Range temperatures_;  // at which all of them are valid
  std::size_t temperature_slot_ = 0;

  bool kernel_alone_ = true;  // nothing but the kernel
  // Order of the memory: kernel, other elements, force effects, temperature with its factors, which is all that a trial
  // step of the series balance needs; then displacement effects, rig, and the two displacements.
  std::size_t memory_size_ = 0;
  std::size_t trial_size_ = 0;
};

}  // namespace rubber_suspension::component
