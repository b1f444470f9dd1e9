// Detects a motion that is odd for a component, such as millimetres in a column of metres.
#pragma once

#include <optional>
#include <string>

#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::gap {

/// The amplitude for which a component is made [m]: the nominal one or, if there is none, the longest length among the
/// parameters. It is nullopt if there is no length either.
using MotionScale = std::optional<double>;

MotionScale motionScaleOf(const io::ComponentDescription& description);

/// Describes an odd amplitude [m] for a component as "5 m is 2500 times ...". Returns nullopt if it is not odd.
std::optional<std::string> oddAmplitude(double amplitude, const MotionScale& scale);

/// Describes a log that is odd for a component, or returns nullopt. If the measured force varies, compares the
/// stiffness of the log with that of the component, whose force for the same displacements is `force` [N]. Otherwise
/// checks the amplitude.
std::optional<std::string> oddMotion(const log::Log& log, const std::vector<double>& force, const MotionScale& scale);

/// Describes an odd log as above. Uses the static force at the largest and the smallest displacement as `force`.
std::optional<std::string> oddMotion(const log::Log& log, const io::ComponentDescription& description);

/// Describes the part of a log beyond the displacements for which a component is valid. Returns nullopt if there is no
/// such part, or if the component states no range.
std::optional<std::string> beyondValid(const log::Log& log, const io::ComponentDescription& description);

}  // namespace rubber_suspension::gap
