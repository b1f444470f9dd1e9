// Bounds of a message on the wire, checked before it is decoded, because decoders allocate what a message claims to
// contain. Independent of ROS.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::node {

constexpr std::size_t kLongestFrameId = 255;        ///< bytes of a header's frame_id
constexpr std::size_t kLongestComponentName = 100;  ///< bytes, as in component files

/// True if these bytes are a header and that many float64, to the last byte: 1 of a Displacement or MeasuredForce, 2 of
/// a sensor_msgs/Temperature, 7 of a geometry_msgs/PoseStamped, 6 of a WrenchStamped.
template <std::size_t kNumbers>
bool isStamped(const std::uint8_t* data, std::size_t size);

/// Its kind.
using MessageCheck = bool(const std::uint8_t* data, std::size_t size);

constexpr std::size_t kPoseNumbers = 7;    ///< position and quaternion
constexpr std::size_t kWrenchNumbers = 6;  ///< force and moment

/// True if these bytes are a DisplacementArray (`numbers` 1) or PoseArray (kPoseNumbers), to the last byte, with at
/// most that many names and entries.
bool isBundle(const std::uint8_t* data, std::size_t size, std::size_t most_components, std::size_t numbers = 1);

/// Bytes of the longest such message of that number of components.
std::size_t longestBundle(std::size_t components, std::size_t numbers = 1);

}  // namespace rubber_suspension::node
