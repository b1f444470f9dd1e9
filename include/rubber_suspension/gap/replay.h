// Simulates a component on a recorded log, offline.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::gap {

/// Throws LogError, with the first such sample, where a log has a temperature at which the component's shifts do not
/// hold. `first`: the place of the first sample, where these are a part of a log.
void checkTemperature(const component::Component& component, const log::Log& log, std::size_t first = 0);

/// The force [N] at every sample of a log, by the same stream that the node feeds: the same numbers to the last bit.
/// The component is new and at rest at the log's first displacement, at the log's temperature where it has one. Shows
/// progress on a terminal. `counters`, if given, receives what the stream counted. Throws LogError as checkLog does,
/// where a force is not finite, and where a temperature is none at which the component's shift holds.
std::vector<double> simulateLog(const component::Component& component, const log::Log& log,
                                component::StreamCounters* counters = nullptr);

/// The result of a simulation of a log.
struct Replay {
  std::vector<double> force;  ///< [N], one per sample
  std::uint64_t bridged = 0;  ///< time gaps longer than the stream's max_gap
};

/// Simulates a log. Throws as simulateLog does.
Replay replay(const component::Component& component, const log::Log& log);

/// Treatment of the mean difference in a gap.
enum class Offset { kept, removed };

/// One line for the terminal: samples, duration, range of the force and, with a measured force, the gap.
std::string summary(const std::string& component, const log::Log& log, const Replay& replay,
                    Offset offset = Offset::kept);

/// The names of the force of the log and of the other one in a figure, and what is drawn of them.
struct ForceLabels {
  std::string log = "measured";
  std::string force = "simulated";
  std::string quantity = "force [kN]";
  double factor = 1e-3;  ///< from SI to its unit
};

/// The last cycles: force over displacement and over time, measured less simulated below; and the whole log by its
/// smallest and largest residual, or force.
io::Figure replayFigure(const std::string& component, const log::Log& log, const std::vector<double>& force,
                        const ForceLabels& labels = {});

/// The last cycles of each direction that moves or carries a load: force over coordinate and over time.
io::Figure replayFigure(const std::string& component, const log::PoseLog& log,
                        const std::array<std::vector<double>, 6>& wrench);

}  // namespace rubber_suspension::gap
