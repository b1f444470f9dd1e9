// Fuzz target: any numbers restored as the state of a component are refused, or at worst lead to wrong forces. Every
// sample is counted once, and dropped samples have no effect.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "fuzz/component_bytes.h"

using namespace rubber_suspension::fuzz;
using rubber_suspension::component::StreamForce;

namespace {

/// Replaces some numbers of the memory by whole numbers, such as indices and counts, or by arbitrary numbers.
std::vector<double> chosenMemory(Bytes& bytes, std::vector<double> memory) {
  std::uint8_t changes = 0;
  bytes.read(changes);
  for (; changes > 0; --changes) {
    std::uint16_t place = 0;
    std::uint8_t kind = 0;
    std::int32_t whole = 0;
    if (!bytes.read(place) || !bytes.read(kind) || memory.empty()) {
      break;
    }
    double& number = memory[place % memory.size()];
    if (kind % 2 == 0) {
      bytes.read(number);
    } else if (bytes.read(whole)) {
      number = whole >> (kind % 32);
    }
  }
  return memory;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const Component component = chosenComponent(bytes);
  SampleStream stream(component);
  std::int64_t stamp = 0;
  double displacement = 0.0;
  const std::vector<double> memory = chosenMemory(bytes, stream.state().memory());
  const std::vector<double> before = stream.state().memory();
  try {
    stream.deserialise(stamp, displacement, memory);
  } catch (const std::invalid_argument&) {
    require(stream.state().memory() == before && !stream.started(), "what is refused leaves no trace");
    return 0;
  }
  for (std::uint64_t pushed = 1; nextSample(bytes, stamp, displacement); ++pushed) {
    const std::int64_t stamp_before = stream.lastStamp();
    const StreamForce result = stream.push(stamp, displacement);
    if (rubber_suspension::component::isAccepted(result.acceptance)) {
      require(std::isfinite(result.force.total), "the force of an accepted sample is finite");
    } else {
      require(stream.lastStamp() == stamp_before, "a drop leaves no trace");
    }
    require(stream.counters().accepted + stream.counters().dropped() == pushed, "every sample is counted once");
  }
  return 0;
}
