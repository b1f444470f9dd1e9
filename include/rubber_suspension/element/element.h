// Interfaces of the laws. The object of a law contains its parameters; the caller owns its memory. No law throws.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <optional>

#include "rubber_suspension/element/basic_laws.h"

namespace rubber_suspension::element {

/// Motion since the previous sample, linear in time.
struct Motion {
  double dt;            ///< time since the previous sample [s], greater than 0
  double displacement;  ///< displacement at the end of the step [m]
  double increment;     ///< displacement minus the previous displacement [m]
};

/// Part of a component's force to which an element contributes.
enum class Part { elastic, viscous, friction };

/// Force of a component and its parts [N]. Positive displacement gives positive force.
struct ComponentForce {
  double total = 0.0;
  double elastic = 0.0;
  double viscous = 0.0;
  double friction = 0.0;
};

/// Place of a law in the path from displacement to force.
enum class Action {
  adds_force,               ///< adds its force to the forces of other laws
  displaces,                ///< changes the displacement on which other laws act
  scales_force,             ///< multiplies the force of other laws by a factor
  yields,                   ///< is in series with the sum of all laws that add force
  shifts_with_temperature,  ///< scales rates and force of other laws with temperature
};

/// Base of all laws: an immutable object whose memory is a block of doubles that the caller owns.
///
/// Since memory and law are separate, a trial step is a step on a copy of the memory, a copy of the memory saves the
/// state, and one object serves any number of simulations at once. No method allocates.
class Element {
 public:
  virtual ~Element() = default;

  /// Returns the number of doubles of memory.
  virtual std::size_t memorySize() const { return 0; }

  /// Returns true if the law can continue from a memory of finite numbers whose origin is unknown. A law with indices
  /// or counts in its memory has to check them.
  virtual bool acceptsMemory(const double* /*memory*/) const { return true; }

  virtual Action action() const = 0;

  /// Returns true for parts of the rig (fixture mass, load cell). Such parts follow the displacement of the actuator,
  /// and their force is added after the effects on the force of the test piece.
  virtual bool onRig() const { return false; }

  /// Returns true for effects of the measuring chain on a signal (delay, gain, offset, drift), which are never part of
  /// the rubber.
  virtual bool ofMeasuringChain() const { return false; }

  /// Returns true if the force is linear in the displacement's history, except for a constant or a trend.
  virtual bool linear() const = 0;

  /// Returns true if the law, starting from rest, never returns more energy than it received, alone or with a passive
  /// test piece. Examples that are not passive are offsets and drifts, parts of a characteristic that need a parallel
  /// spring, and shifts with temperature.
  virtual bool passive() const { return true; }
};

/// A law that adds its force to the forces of other laws: spring, dashpot, Maxwell element, friction, ...
class ParallelElement : public Element {
 public:
  /// Initialises the memory for a component at rest and fully relaxed at this displacement [m]; returns the force [N].
  /// The default sets the memory to zeros and returns 0.
  virtual double initialise(double /*displacement*/, double* memory) const {
    std::fill_n(memory, memorySize(), 0.0);
    return 0.0;
  }

  /// Sets the memory to its state after a long rest at this displacement [m], which does not undo permanent changes;
  /// returns the force [N].
  virtual double relax(double displacement, double* memory) const { return initialise(displacement, memory); }

  /// Advances the memory over one step and returns the force at its end [N].
  virtual double step(const Motion& motion, double* memory) const = 0;

  virtual Part part() const = 0;

  /// Adds the parameters of a basic law to a sum of basic laws, which a component steps together. Any other law returns
  /// false and changes nothing.
  virtual bool addTo(BasicLaws& /*sum*/) const { return false; }

  /// Returns K*(omega) [N/m] of a linear law at an angular frequency [rad/s], or nullopt for a nonlinear law.
  virtual std::optional<std::complex<double>> complexStiffness(double /*omega*/) const { return std::nullopt; }

  Action action() const final { return Action::adds_force; }
  bool linear() const final { return complexStiffness(1.0).has_value(); }
};

/// A law between the actuator and the test piece that changes the displacement: delay, free play.
class DisplacementEffect : public Element {
 public:
  /// Initialises as ParallelElement::initialise does; returns the displacement behind the effect [m].
  virtual double initialise(double displacement, double* memory) const = 0;

  /// Advances over one step and returns the displacement behind the effect at its end [m].
  virtual double step(const Motion& motion, double* memory) const = 0;

  /// Returns true for effects of a sensor (delay), which act before all other effects on the displacement.
  virtual bool ofSensor() const { return false; }

  /// Returns the factor of a linear law on a sinusoidal displacement at omega [rad/s], or nullopt for a nonlinear law.
  virtual std::optional<std::complex<double>> transfer(double /*omega*/) const { return std::nullopt; }

  Action action() const final { return Action::displaces; }
  bool linear() const final { return transfer(1.0).has_value(); }
};

/// A law that scales the force of the test piece by a factor, which may depend on the history: stress softening.
class ForceEffect : public Element {
 public:
  /// Initialises the memory for a new test piece at rest at this displacement [m]. The factor at this displacement is
  /// constantFactor(), or 1 if the factor varies.
  virtual void initialise(double displacement, double* memory) const = 0;

  /// Sets the memory to its state after a long rest at this displacement [m], which does not undo permanent changes;
  /// returns the factor on the force.
  virtual double relax(double displacement, double* memory) const {
    initialise(displacement, memory);
    return 1.0;
  }

  /// Advances over one step and returns the factor on the force of the test piece. `force` does not include the factor.
  virtual double step(const Motion& motion, const ComponentForce& force, double* memory) const = 0;

  /// Returns the factor if it is constant, otherwise nullopt.
  virtual std::optional<double> constantFactor() const { return std::nullopt; }

  Action action() const final { return Action::scales_force; }
  bool linear() const final { return constantFactor().has_value(); }
};

/// Series compliance: an elastic law in series with the whole test piece, such as a compliant bracket or rig.
class SeriesElement : public Element {
 public:
  /// Deflection per force [m/N]; infinite for a contact that opens.
  struct Compliance {
    double tension;        ///< compliance for F > 0
    double compression;    ///< compliance for F < 0
    double preload = 0.0;  ///< magnitude of the force while a contact is open [N]
  };

  /// Returns the deflection [m] under a force [N]. It has the sign of the force and never decreases while the force
  /// grows.
  virtual double deflection(double force) const = 0;

  /// Returns the compliance if the law is linear for each sign of the force, otherwise nullopt.
  virtual std::optional<Compliance> compliance() const = 0;

  Action action() const final { return Action::yields; }
  bool linear() const final {
    const std::optional<Compliance> sides = compliance();
    return sides && sides->tension == sides->compression;
  }
};

}  // namespace rubber_suspension::element
