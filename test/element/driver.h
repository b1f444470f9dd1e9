// Steps a law by itself, for tests of its own formulas.
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "rubber_suspension/element/element.h"

namespace rubber_suspension::test {

/// A law whose force adds (or an effect on displacement), with its memory and the last displacement.
template <class Law>
class Driver {
 public:
  explicit Driver(const Law& law, double start = 0.0) : Driver(std::make_shared<const Law>(law), start) {}
  explicit Driver(std::shared_ptr<const Law> law, double start = 0.0)
      : law_(std::move(law)), memory_(law_->memorySize()), displacement_(start) {
    output_ = law_->initialise(start, memory_.data());
  }

  /// Output (force [N] or displacement [m]) after a step of dt [s] to a displacement [m].
  double step(double dt, double displacement) {
    const element::Motion motion{dt, displacement, displacement - displacement_};
    displacement_ = displacement;
    return output_ = law_->step(motion, memory_.data());
  }

  /// The same along a straight line in many steps; returns the work done [J] by the trapezoidal rule.
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

 private:
  std::shared_ptr<const Law> law_;
  std::vector<double> memory_;
  double displacement_;
  double output_;
};

/// Work of one closed cycle between -amplitude and amplitude from -amplitude on [J], after `settling` cycles.
template <class Law>
double settledWork(Driver<Law>& driver, double amplitude, int settling, int steps) {
  driver.walk(1.0, -amplitude, steps);
  for (int i = 0; i < settling; ++i) {
    driver.walk(1.0, amplitude, steps);
    driver.walk(1.0, -amplitude, steps);
  }
  const double up = driver.walk(1.0, amplitude, steps);
  return up + driver.walk(1.0, -amplitude, steps);
}

}  // namespace rubber_suspension::test
