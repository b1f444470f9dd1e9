// Force that grows with time whatever the displacement: drift of a load cell. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = r t, t being the time since the start. Opens every loop; its dynamic stiffness is 0.
/// Validity: the linear trend over one record; a load cell that warms up levels off later. Memory: the time.
class ForceDrift final : public ParallelElement {
 public:
  explicit ForceDrift(double rate /* r [N/s] */) : rate_(rate) {}

  std::size_t memorySize() const override { return 1; }
  double step(const Motion& motion, double* memory) const override { return rate_ * (memory[0] += motion.dt); }
  Part part() const override { return Part::elastic; }
  bool onRig() const override { return true; }
  bool ofMeasuringChain() const override { return true; }
  bool passive() const override { return false; }
  std::optional<std::complex<double>> complexStiffness(double /*omega*/) const override { return 0.0; }

 private:
  double rate_;
};

ElementType forceDriftType();

}  // namespace rubber_suspension::element
