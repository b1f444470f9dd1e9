// Displacements that predict the residual of another direction's force.
#pragma once

#include <array>
#include <vector>

#include "rubber_suspension/diagnosis/six_directions.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::diagnosis::results {

/// Directions of a log, with what is left of their forces in place of these.
using DirectionResiduals = std::array<log::Log, component::kDirections>;

/// CrossShare of a pair over all logs.
CrossShare crossShare(const std::vector<DirectionResiduals>& logs, component::Direction of, component::Direction by);

}  // namespace rubber_suspension::diagnosis::results
