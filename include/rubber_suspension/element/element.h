// The interfaces that every law implements; a law has its parameters, the caller its memory. No law throws.
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
  double displacement;  ///< at the end of the step [m]
  double increment;     ///< displacement minus that of the previous sample [m]
};

/// Part of a component's force to which an element contributes.
enum class Part { elastic, viscous, friction };

/// Force of a component and the parts that it consists of [N]. Positive displacement gives positive force.
struct ComponentForce {
  double total = 0.0;
  double elastic = 0.0;
  double viscous = 0.0;
  double friction = 0.0;
};

/// Place of a law in the path from displacement to force.
enum class Action {
  adds_force,               ///< its force adds to that of the others
  displaces,                ///< changes the displacement before the others see it
  scales_force,             ///< a factor on the force of the others
  yields,                   ///< in series with all that adds force
  shifts_with_temperature,  ///< rates and force of the others, by the temperature
};

/// Base of all laws: an immutable object whose memory is a block of doubles that the caller owns.
///
/// Because memory is apart, a trial step is a step on a copy, saving a state is copying numbers, and one object
/// serves any number of simulations at once. No method allocates.
class Element {
 public:
  virtual ~Element() = default;

  /// Number of doubles of memory.
  virtual std::size_t memorySize() const { return 0; }

  /// True if the law can continue from these finite numbers, whose origin is unknown: indices and counts among them
  /// have to be valid.
  virtual bool acceptsMemory(const double* /*memory*/) const { return true; }

  virtual Action action() const = 0;

  /// True for parts of the rig (fixture mass, load cell): they follow the actuator's displacement, without effects on
  /// the test piece's force.
  virtual bool onRig() const { return false; }

  /// True for effects of the measuring chain on a signal (delay, gain, offset, drift), which are never part of the
  /// rubber.
  virtual bool ofMeasuringChain() const { return false; }

  /// True if the force is linear in the displacement's history, except for a constant or a trend.
  virtual bool linear() const = 0;

  /// True if, from rest on, it never returns more energy than it received, by itself or on a passive test piece. Active
  /// are errors of a measuring chain, which add or shift forces; parts of a characteristic that need a parallel spring;
  /// and a test piece that is loaded cold and unloaded hot.
  virtual bool passive() const { return true; }
};

/// A law whose force adds to that of the others: spring, dashpot, Maxwell element, friction, ...
class ParallelElement : public Element {
 public:
  /// Initialises the memory for a component at rest at this displacement [m], relaxed since long; returns the force
  /// [N]. Zeros and no force, unless a law says otherwise.
  virtual double initialise(double /*displacement*/, double* memory) const {
    std::fill_n(memory, memorySize(), 0.0);
    return 0.0;
  }

  /// Brings the memory to what a long rest at this displacement [m] leaves of it (what is permanent stays); returns the
  /// force there [N].
  virtual double relax(double displacement, double* memory) const { return initialise(displacement, memory); }

  /// Advances the memory over one step and returns the force at its end [N].
  virtual double step(const Motion& motion, double* memory) const = 0;

  virtual Part part() const = 0;

  /// Adds a basic law to a sum, which a component steps at once. Returns false, without effect, for any other law.
  virtual bool addTo(BasicLaws& /*sum*/) const { return false; }

  /// K*(omega) [N/m] at angular frequency omega [rad/s] of a linear law; nothing for a nonlinear one.
  virtual std::optional<std::complex<double>> complexStiffness(double /*omega*/) const { return std::nullopt; }

  Action action() const final { return Action::adds_force; }
  bool linear() const final { return complexStiffness(1.0).has_value(); }
};

/// A law between the actuator and the test piece that changes the displacement: delay, free play.
class DisplacementEffect : public Element {
 public:
  /// As ParallelElement::initialise; returns the displacement behind the effect [m].
  virtual double initialise(double displacement, double* memory) const = 0;

  /// Advances over one step and returns the displacement behind the effect at its end [m].
  virtual double step(const Motion& motion, double* memory) const = 0;

  /// True for effects of a sensor (delay), which precede all others between actuator and test piece.
  virtual bool ofSensor() const { return false; }

  /// Factor on the displacement under a sine, of a linear law; nothing for a nonlinear one.
  virtual std::optional<std::complex<double>> transfer(double /*omega*/) const { return std::nullopt; }

  Action action() const final { return Action::displaces; }
  bool linear() const final { return transfer(1.0).has_value(); }
};

/// A law that scales the force of the test piece by its history: stress softening, self-heating.
class ForceEffect : public Element {
 public:
  /// Initialises the memory for a new test piece at rest at this displacement [m]; the factor is then 1, or
  /// the constant one.
  virtual void initialise(double displacement, double* memory) const = 0;

  /// Brings the memory to what a long rest at this displacement [m] leaves of it (what is permanent stays); returns the
  /// factor on the force there.
  virtual double relax(double displacement, double* memory) const {
    initialise(displacement, memory);
    return 1.0;
  }

  /// Advances over one step; returns the factor on the force of the test piece, `force` being that without the effect.
  virtual double step(const Motion& motion, const ComponentForce& force, double* memory) const = 0;

  /// Returns the factor of a law with a constant one, else nullopt.
  virtual std::optional<double> constantFactor() const { return std::nullopt; }

  Action action() const final { return Action::scales_force; }
  bool linear() const final { return constantFactor().has_value(); }
};

/// Series compliance: an elastic law in series with the whole test piece, such as a compliant bracket or rig.
class SeriesElement : public Element {
 public:
  /// Deflection per force [m/N]; infinite for a contact that opens.
  struct Compliance {
    double tension;        ///< for F > 0
    double compression;    ///< for F < 0
    double preload = 0.0;  ///< magnitude of the force that an open contact keeps [N]
  };

  /// Deflection under a force [m]: of the force's sign, and nowhere decreasing with it.
  virtual double deflection(double force) const = 0;

  /// Returns the compliance of a law that is linear on each side, else nullopt.
  virtual std::optional<Compliance> compliance() const = 0;

  Action action() const final { return Action::yields; }
  bool linear() const final {
    const std::optional<Compliance> sides = compliance();
    return sides && sides->tension == sides->compression;
  }
};

}  // namespace rubber_suspension::element
