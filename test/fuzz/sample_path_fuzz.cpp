// Fuzz target: a component of any elements, fed with any stamps and displacements, keeps a finite state, counts every
// sample once and drops without a trace what it drops.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "element/typical_elements.h"
#include "rubber_suspension/component/sample_stream.h"

using rubber_suspension::component::Component;
using rubber_suspension::component::SampleStream;
using rubber_suspension::component::StreamForce;
using rubber_suspension::element::ElementDescription;

namespace {

void require(bool condition, const char* what) {
  if (!condition) {
    std::fprintf(stderr, "violated: %s\n", what);
    std::abort();
  }
}

/// Reads values off the fuzzer's bytes until there are none left.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  template <class Value>
  bool read(Value& value) {
    if (left_ < sizeof(Value)) {
      return false;
    }
    std::memcpy(&value, data_, sizeof(Value));
    data_ += sizeof(Value);
    left_ -= sizeof(Value);
    return true;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

/// The elements that the bytes choose of the typical ones: how many, then which, each of them once; always a spring, so
/// that there is a component.
Component chosenComponent(Bytes& bytes) {
  const std::vector<ElementDescription> all = rubber_suspension::test::typicalElements();
  std::vector<bool> is_chosen(all.size(), false);
  is_chosen.front() = true;
  std::vector<ElementDescription> chosen = {all.front()};
  std::uint8_t choices = 0;
  bytes.read(choices);
  for (std::uint8_t choice = 0; choices > 0 && bytes.read(choice); --choices) {
    const std::size_t i = choice % all.size();
    if (!is_chosen[i]) {
      is_chosen[i] = true;
      chosen.push_back(all[i]);
    }
  }
  return Component(chosen);
}

bool allFinite(const std::vector<double>& values) {
  for (const double value : values) {
    if (!std::isfinite(value)) {
      return false;
    }
  }
  return true;
}

/// The next sample: steps from a nanosecond to hours, ahead and back, and now and then any 64 bits.
bool nextSample(Bytes& bytes, std::int64_t& stamp, double& displacement) {
  std::uint8_t kind = 0;
  std::int16_t step = 0;
  std::int16_t position = 0;
  if (!bytes.read(kind) || !bytes.read(step)) {
    return false;
  }
  const std::int64_t unit[] = {1, 1000, 1000000, 100000000};
  if (kind % 16 == 15) {
    std::uint32_t anywhere = 0;  // a ROS stamp has 32 bits of seconds
    bytes.read(anywhere);
    stamp = static_cast<std::int64_t>(anywhere) * SampleStream::kNanosecondsPerSecond;
  } else {
    stamp = std::max<std::int64_t>(0, stamp + step * unit[kind % 4]);
  }
  if (kind / 16 == 15) {
    return bytes.read(displacement);
  }
  const double scale[] = {1e-9, 1e-6, 1e-4, 1.0};  // [m] to a count of 32768
  const bool more = bytes.read(position);
  displacement = position * scale[kind / 16 % 4] / 32.0;
  return more;
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
