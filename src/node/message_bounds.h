// What a message on the wire may be before it is decoded: decoders make room for what a message claims to hold. Knows
// no ROS.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::node {

constexpr std::size_t kLongestFrameId = 255;        ///< bytes of a header's frame_id
constexpr std::size_t kLongestComponentName = 100;  ///< bytes; the component file has none longer

/// True if these bytes are a header and one float64, to the last byte: Displacement and MeasuredForce.
bool isStampedNumber(const std::uint8_t* data, std::size_t size);

/// True if these bytes are a header and two float64, to the last byte: sensor_msgs/Temperature.
bool isStampedPair(const std::uint8_t* data, std::size_t size);

/// True if these bytes are a DisplacementArray, to the last byte, with at most that many names and numbers.
bool isBundle(const std::uint8_t* data, std::size_t size, std::size_t most_components);

/// Bytes of the longest DisplacementArray of that number of components.
std::size_t longestBundle(std::size_t components);

}  // namespace rubber_suspension::node
