// Gain error of the force channel.
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Multiplies the force by 1 + g with the gain error g of an amplifier or a load cell that is not calibrated.
///
/// The factor acts on the force of the test piece; forces of rig masses and offsets are added afterwards. A gain error
/// cannot be distinguished from a common factor on all stiffnesses and dampings. Validity: with a series compliance
/// only a small g, since the deflection follows the recorded force.
class SensorGain final : public ForceEffect {
 public:
  explicit SensorGain(double gain /* g [-] */) : factor_(1.0 + gain) {}

  void initialise(double /*displacement*/, double* /*memory*/) const override {}
  double relax(double /*displacement*/, double* /*memory*/) const override { return factor_; }
  double step(const Motion& /*motion*/, const ComponentForce& /*force*/, double* /*memory*/) const override {
    return factor_;
  }
  std::optional<double> constantFactor() const override { return factor_; }
  bool ofMeasuringChain() const override { return true; }

 private:
  double factor_;
};

const ElementEntry kSensorGainEntry(
    440, {"sensor_gain",
          "Wrong gain of the force channel: the recorded force is 1 + g times the force of the test piece.",
          {{"gain", "1", Role::shape, Range::closed(-0.9, 9.0), "error g of the gain"}},
          makes<SensorGain>("gain")});

}  // namespace
}  // namespace rubber_suspension::element
