// Prediction of the residual of one direction's force by the displacement of another.
#pragma once

#include <array>
#include <vector>

#include "rubber_suspension/diagnosis/six_directions.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::diagnosis::results {

/// Directions of a log, with residuals in place of forces.
using DirectionResiduals = std::array<log::Log, component::kDirections>;

/// Returns the CrossShare of a pair of directions over all logs.
CrossShare crossShare(const std::vector<DirectionResiduals>& logs, component::Direction of, component::Direction by);

}  // namespace rubber_suspension::diagnosis::results
