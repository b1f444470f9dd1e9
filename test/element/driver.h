// Classes and functions that step a single law, for tests of its formulas.
#pragma once

#include "rubber_suspension/element/catalogue.h"
#include "support/kit.h"

namespace rubber_suspension::test {

using Law = std::shared_ptr<const element::ParallelElement>;

/// Returns the law of an entry that adds a force.
inline Law lawOf(const element::ElementDescription& description) {
  return std::get<Law>(element::makeElement(description));
}
inline Law lawOf(const std::string& text) { return lawOf(entry(text)); }

/// Returns the force [N] of a law at rest at a displacement [m].
inline double forceAt(const Law& law, double displacement) {
  std::vector<double> memory(law->memorySize());
  return law->initialise(displacement, memory.data());
}

/// Steps a law that adds a force or changes the displacement, and stores its memory and displacement.
class Driver {
 public:
  explicit Driver(const std::string& text, double start = 0.0) : Driver(entry(text), start) {}
  explicit Driver(const element::ElementDescription& description, double start = 0.0)
      : element_(element::makeElement(description)),
        memory_(element::lawOf(element_).memorySize()),
        displacement_(start) {
    output_ = apply([&](const auto& law) { return law.initialise(start, memory_.data()); });
  }

  /// Steps by dt [s] to a displacement [m], and returns the output: a force [N] or a displacement [m].
  double step(double dt, double displacement) {
    const element::Motion motion{dt, displacement, displacement - displacement_};
    displacement_ = displacement;
    return output_ = apply([&](const auto& law) { return law.step(motion, memory_.data()); });
  }

  /// Relaxes fully at the present displacement and returns the force [N].
  double relax() { return output_ = law().relax(displacement_, memory_.data()); }

  /// Moves along a straight line in `steps` steps, and returns the work [J] from the trapezoidal rule.
  double walk(double duration, double displacement, int steps) {
    const double start = displacement_;
    double work = 0.0;
    for (int i = 1; i <= steps; ++i) {
      const double before = output_;
      const double last = displacement_;
      const double force = step(duration / steps, start + (displacement - start) * i / steps);
      work += 0.5 * (before + force) * (displacement_ - last);
    }
    return work;
  }

  double output() const { return output_; }
  double displacement() const { return displacement_; }
  double* memory() { return memory_.data(); }
  const element::ParallelElement& law() const { return *element::parallelLaw(element_); }

 private:
  template <class Action>
  double apply(const Action& action) const {
    const auto* effect = std::get_if<std::shared_ptr<const element::DisplacementEffect>>(&element_);
    return effect != nullptr ? action(**effect) : action(law());
  }

  element::ElementPointer element_;
  std::vector<double> memory_;
  double displacement_;
  double output_;
};

/// Returns the work [J] of one cycle from -amplitude to amplitude and back, after `settling` cycles.
inline double settledWork(Driver& driver, double amplitude, int settling, int steps) {
  driver.walk(1.0, -amplitude, steps);
  for (int i = 0; i < settling; ++i) {
    driver.walk(1.0, amplitude, steps);
    driver.walk(1.0, -amplitude, steps);
  }
  const double up = driver.walk(1.0, amplitude, steps);
  return up + driver.walk(1.0, -amplitude, steps);
}

}  // namespace rubber_suspension::test
