// The interfaces that every law implements; a law keeps its parameters, its memory is handed in.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>

namespace rubber_suspension::element {

/// How the displacement moved since the previous sample; it is taken as linear in between.
struct Motion {
  double dt;            ///< time since the previous sample [s], greater than 0
  double displacement;  ///< at the end of the step [m]
  double increment;     ///< displacement minus that of the previous sample [m]
};

/// Which part of a component's force an element contributes to.
enum class Part { elastic, viscous, friction };

/// Force of a component and the parts that it consists of [N]. Positive displacement gives positive force.
struct ComponentForce {
  double total = 0.0;
  double elastic = 0.0;
  double viscous = 0.0;
  double friction = 0.0;
};

/// Common to all laws: an immutable object whose memory is a block of doubles that the caller owns.
///
/// Because memory is apart, a trial step is a step on a copy, saving a state is copying numbers, and one object
/// serves any number of simulations at once. No method allocates.
class Element {
 public:
  virtual ~Element() = default;

  /// Number of doubles of memory.
  virtual std::size_t memorySize() const { return 0; }
};

/// A law whose force adds to that of the others: spring, dashpot, Maxwell element, friction, ...
class ParallelElement : public Element {
 public:
  /// Initialise the memory for a component at rest at this displacement [m], relaxed since long; returns the force [N].
  virtual double initialise(double displacement, double* memory) const = 0;

  /// Advance the memory over one step and return the force at its end [N].
  virtual double step(const Motion& motion, double* memory) const = 0;

  virtual Part part() const = 0;

  /// True for what belongs to the rig (fixture mass, load cell): it sees the actuator's displacement, and effects on
  /// the specimen's force pass it by.
  virtual bool onRig() const { return false; }

  /// K*(omega) [N/m] at angular frequency omega [rad/s] of a linear law; nothing for a nonlinear one.
  virtual std::optional<std::complex<double>> complexStiffness(double /*omega*/) const { return std::nullopt; }
};

/// A law between the actuator and the specimen that changes the displacement: delay, free play.
class DisplacementEffect : public Element {
 public:
  /// As ParallelElement::initialise; returns the displacement behind the effect [m].
  virtual double initialise(double displacement, double* memory) const = 0;

  /// Advance over one step and return the displacement behind the effect at its end [m].
  virtual double step(const Motion& motion, double* memory) const = 0;

  /// Factor on the displacement under a sine, of a linear law; nothing for a nonlinear one.
  virtual std::optional<std::complex<double>> transfer(double /*omega*/) const { return std::nullopt; }
};

/// A law that scales the specimen's force by its history: stress softening, self-heating.
class ForceEffect : public Element {
 public:
  /// Initialise the memory for a new specimen at rest at this displacement [m]; the factor is then 1.
  virtual void initialise(double displacement, double* memory) const = 0;

  /// Bring the memory to what a long rest at this displacement [m] leaves of it (what is permanent stays); returns the
  /// factor on the force there.
  virtual double relax(double displacement, double* memory) const {
    initialise(displacement, memory);
    return 1.0;
  }

  /// Advance over one step; returns the factor on the specimen's force, `force` being that without the effect.
  virtual double step(const Motion& motion, const ComponentForce& force, double* memory) const = 0;
};

/// An elastic law in series with the whole specimen: bracket, mount, joint or rig that yields.
class SeriesElement : public Element {
 public:
  /// Deflection per force [m/N].
  struct Compliance {
    double tension;      ///< for F > 0
    double compression;  ///< for F < 0
  };

  /// By how much it yields to a force [m]: of the force's sign, and nowhere falling with it.
  virtual double deflection(double force) const = 0;

  /// Of a law that is linear to either side; nothing for another.
  virtual std::optional<Compliance> compliance() const = 0;
};

}  // namespace rubber_suspension::element
