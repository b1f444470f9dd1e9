// Constant force: offset of a load cell, or a preload that the displacement does not include.
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = F_0. It changes the mean force only, so its dynamic stiffness is 0.
class ForceOffset final : public ParallelElement {
 public:
  explicit ForceOffset(double offset /* F_0 [N] */) : offset_(offset) {}

  double initialise(double /*displacement*/, double* /*memory*/) const override { return offset_; }
  double step(const Motion& /*motion*/, double* /*memory*/) const override { return offset_; }
  Part part() const override { return Part::elastic; }
  bool onRig() const override { return true; }
  bool ofMeasuringChain() const override { return true; }
  bool passive() const override { return false; }
  std::optional<std::complex<double>> complexStiffness(double /*omega*/) const override { return 0.0; }

 private:
  double offset_;
};

const ElementEntry kForceOffsetEntry(450, {"force_offset",
                                           "Constant force: zero error of the load cell, or a preload.",
                                           {{"offset", "N", Role::scale, Range::any(),
                                             "force at zero displacement, of either sign"}},
                                           makes<ForceOffset>("offset")});

}  // namespace
}  // namespace rubber_suspension::element
