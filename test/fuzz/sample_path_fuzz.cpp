// Fuzz target: for any stamps and displacements, any component has a finite state, counts every sample once, and is not
// affected by samples that it drops.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fuzz/component_bytes.h"

using namespace rubber_suspension::fuzz;
using rubber_suspension::component::StreamForce;

namespace {

bool allFinite(const std::vector<double>& values) {
  for (const double value : values) {
    if (!std::isfinite(value)) {
      return false;
    }
  }
  return true;
}

void feed(const Component& component, Bytes bytes) {
  SampleStream stream(component);
  std::uint64_t pushed = 0;
  std::int64_t stamp = 0;
  double displacement = 0.0;
  while (nextSample(bytes, stamp, displacement)) {
    const std::vector<double> before = stream.state().memory();
    const std::int64_t stamp_before = stream.lastStamp();
    const StreamForce result = stream.push(stamp, displacement);
    ++pushed;
    if (rubber_suspension::component::isAccepted(result.acceptance)) {
      require(std::isfinite(result.force.total), "the force of an accepted sample is finite");
      require(allFinite(stream.state().memory()), "the state stays finite");
      require(stream.lastStamp() == stamp, "an accepted sample sets the time");
    } else {
      require(stream.state().memory() == before && stream.lastStamp() == stamp_before, "a drop leaves no trace");
    }
    require(stream.counters().accepted + stream.counters().dropped() == pushed, "every sample is counted once");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const Component component = chosenComponent(bytes);
  feed(component, bytes);
  return 0;
}
