// Predicts the residual of one direction's force by the displacement of another direction.
#pragma once

#include <array>
#include <vector>

#include "rubber_suspension/diagnosis/six_directions.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::diagnosis::results {

/// The six directions of a log, whose force channels contain residuals.
using DirectionResiduals = std::array<log::Log, component::kDirections>;

/// Returns the CrossShare of a pair of directions over all logs.
CrossShare crossShare(const std::vector<DirectionResiduals>& logs, component::Direction of, component::Direction by);

}  // namespace rubber_suspension::diagnosis::results
