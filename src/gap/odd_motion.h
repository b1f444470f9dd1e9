// Detects a motion that is odd for a component, such as millimetres in a column of metres.
#pragma once

#include <optional>
#include <string>

#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::gap {

/// The amplitude for which a component is made [m]: its nominal one, else the longest length among its parameters.
using MotionScale = std::optional<double>;

MotionScale motionScaleOf(const io::ComponentDescription& description);

/// Describes an odd amplitude [m] for a component, as "5 m is 2500 times ..."; nullopt if it is not odd.
std::optional<std::string> oddAmplitude(double amplitude, const MotionScale& scale);

/// Describes an odd log for a component: with a measured force, by its stiffness against that of `force`, the
/// component's for the same displacements [N]; otherwise by its amplitude. Returns nullopt if it is not odd.
std::optional<std::string> oddMotion(const log::Log& log, const std::vector<double>& force, const MotionScale& scale);

/// Describes a log that is odd for a component, as above, but without a simulation: by the static force at the largest
/// and the smallest displacement of the log.
std::optional<std::string> oddMotion(const log::Log& log, const io::ComponentDescription& description);

/// Describes the part of a log beyond the displacements for which a component is valid; nullopt if there is none, or
/// the component states no range.
std::optional<std::string> beyondValid(const log::Log& log, const io::ComponentDescription& description);

}  // namespace rubber_suspension::gap
