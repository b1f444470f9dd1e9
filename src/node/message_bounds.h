// Bounds of a serialised message, checked before it is decoded, because decoders allocate whatever size a message
// claims to have. Independent of ROS.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::node {

constexpr std::size_t kLongestFrameId = 255;        ///< bytes of a header's frame_id
constexpr std::size_t kLongestComponentName = 100;  ///< bytes, as in component files

/// Returns true if the bytes are exactly a header and kNumbers float64: 1 for a Displacement or MeasuredForce, 2 for a
/// sensor_msgs/Temperature, 7 for a geometry_msgs/PoseStamped, 6 for a WrenchStamped.
template <std::size_t kNumbers>
bool isStamped(const std::uint8_t* data, std::size_t size);

/// Signature of such a check.
using MessageCheck = bool(const std::uint8_t* data, std::size_t size);

constexpr std::size_t kPoseNumbers = 7;    ///< position and quaternion
constexpr std::size_t kWrenchNumbers = 6;  ///< force and moment

/// Returns true if the bytes are exactly a DisplacementArray (`numbers` 1) or PoseArray (kPoseNumbers) with at most
/// `most_components` names and entries.
bool isBundle(const std::uint8_t* data, std::size_t size, std::size_t most_components, std::size_t numbers = 1);

/// Returns the size of the longest such message for a number of components [bytes].
std::size_t longestBundle(std::size_t components, std::size_t numbers = 1);

}  // namespace rubber_suspension::node
