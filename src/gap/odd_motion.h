// Detects a motion that is odd for a component, such as millimetres in a column of metres.
#pragma once

#include <optional>
#include <string>

#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::gap {

/// The amplitude that a component is made for [m]: its nominal one, else the longest displacement among its parameters.
using MotionScale = std::optional<double>;

MotionScale motionScaleOf(const io::ComponentDescription& description);

/// The oddity of an amplitude [m] for a component, as "5 m is 2500 times ..."; nothing where it is not.
std::optional<std::string> oddAmplitude(double amplitude, const MotionScale& scale);

/// The oddity of a log for a component: with a measured force, its stiffness against that of `force`, the
/// component's for the same displacements [N]; else the amplitude. Nothing where neither is.
std::optional<std::string> oddMotion(const log::Log& log, const std::vector<double>& force, const MotionScale& scale);

/// Detects it before a simulation, by the component's static force at the ends of the log's displacement.
std::optional<std::string> oddMotion(const log::Log& log, const io::ComponentDescription& description);

/// The part of a log beyond the displacements for which a component is valid; nothing where all is within, or where it
/// says nothing of them.
std::optional<std::string> beyondValid(const log::Log& log, const io::ComponentDescription& description);

}  // namespace rubber_suspension::gap
