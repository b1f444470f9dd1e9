// Force that grows with time and does not depend on the displacement: drift of a load cell.
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = r t with the time t since the start. The dynamic stiffness is 0, since the force is independent of z.
/// Validity: the linear trend of one log, since the drift of a load cell that warms up levels off. Memory: the time.
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

const ElementEntry kForceDriftEntry(460, {"force_drift",
                                          "Force that grows with time: drift of the load cell.",
                                          {{"rate", "N/s", Role::scale, Range::any(),
                                            "growth of the force per time, of either sign"}},
                                          makes<ForceDrift>("rate")});

}  // namespace
}  // namespace rubber_suspension::element
