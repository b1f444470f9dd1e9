// Gain of the force's channel.
#include "rubber_suspension/element/sensor_gain.h"

namespace rubber_suspension::element {

ElementType sensorGainType() {
  return {"sensor_gain",
          "Wrong gain of the force's channel: the recorded force is 1 + g times that of the test piece.",
          {{"gain", "1", Role::shape, Range::closed(-0.9, 9.0), "error g of the gain"}},
          makes<SensorGain>("gain")};
}

}  // namespace rubber_suspension::element
