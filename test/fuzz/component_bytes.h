// Components with any elements, and samples for them, from the bytes of a fuzz target.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "element/typical_elements.h"
#include "rubber_suspension/component/sample_stream.h"

namespace rubber_suspension::fuzz {

using component::Component;
using component::SampleStream;
using element::ElementDescription;

inline void require(bool condition, const char* what) {
  if (!condition) {
    std::fprintf(stderr, "violated: %s\n", what);
    std::abort();
  }
}

/// Reads values from the bytes of the fuzzer. Fails when too few bytes are left.
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

/// Returns a component of typical elements that the bytes select: first their number, then each element at most once. A
/// spring is always included, because a component must not be empty.
inline Component chosenComponent(Bytes& bytes) {
  const std::vector<ElementDescription> all = test::typicalElements();
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

/// Reads a sample, up to an hour after or before the last one. A few samples have any time or any displacement.
inline bool nextSample(Bytes& bytes, std::int64_t& stamp, double& displacement) {
  std::uint8_t kind = 0;
  std::int16_t step = 0;
  std::int16_t position = 0;
  if (!bytes.read(kind) || !bytes.read(step)) {
    return false;
  }
  const std::int64_t unit[] = {1, 1000, 1000000, 100000000};
  if (kind % 16 == 15) {
    std::uint32_t anywhere = 0;  // a stamp of ROS has 32 bits for the seconds
    bytes.read(anywhere);
    stamp = static_cast<std::int64_t>(anywhere) * SampleStream::kNanosecondsPerSecond;
  } else {
    stamp = std::max<std::int64_t>(0, stamp + step * unit[kind % 4]);
  }
  if (kind / 16 == 15) {
    return bytes.read(displacement);
  }
  const double scale[] = {1e-9, 1e-6, 1e-4, 1.0};  // [m] per 32 counts
  const bool more = bytes.read(position);
  displacement = position * scale[kind / 16 % 4] / 32.0;
  return more;
}

}  // namespace rubber_suspension::fuzz
