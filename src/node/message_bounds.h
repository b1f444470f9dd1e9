// Limits of the size of a serialised message. They are checked before it is decoded, because decoders allocate any size
// that a message claims to have. Independent of ROS.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::node {

constexpr std::size_t kLongestFrameId = 255;        ///< bytes in the frame_id of a header
constexpr std::size_t kLongestComponentName = 100;  ///< bytes, as in component files

/// Returns true if the bytes are exactly a header and kNumbers values of type float64. A Displacement or MeasuredForce
/// has 1 such number, a sensor_msgs/Temperature 2, a geometry_msgs/WrenchStamped 6 and a PoseStamped 7.
template <std::size_t kNumbers>
bool isStamped(const std::uint8_t* data, std::size_t size);

using MessageCheck = bool(const std::uint8_t* data, std::size_t size);

constexpr std::size_t kPoseNumbers = 7;    ///< position and quaternion
constexpr std::size_t kWrenchNumbers = 6;  ///< force and moment

/// Returns true if the bytes are exactly a DisplacementArray (`numbers` is 1) or PoseArray (`numbers` is kPoseNumbers)
/// with at most `most_components` names and entries.
bool isBundle(const std::uint8_t* data, std::size_t size, std::size_t most_components, std::size_t numbers = 1);

/// Returns the size of the longest bundle for a number of components [bytes].
std::size_t longestBundle(std::size_t components, std::size_t numbers = 1);

}  // namespace rubber_suspension::node
