// Simulates a component on a recorded log, offline.
#pragma once

#include <vector>

#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/io/log.h"

namespace rubber_suspension {

/// The force [N] at every sample of a log, by the same stream that the node feeds: the same numbers to the last bit.
/// The specimen is new and at rest at the log's first displacement. Shows progress on a terminal.
/// `counters`, if given, receives what the stream counted. Throws LogError as checkLog does, and where a force is not
/// finite.
std::vector<double> simulateLog(const Component& component, const Log& log, StreamCounters* counters = nullptr);

}  // namespace rubber_suspension
