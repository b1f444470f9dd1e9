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

/// Throws LogError, with the first such sample, if a temperature is outside the range of the component's shift.
/// `first`: index of the first sample if the log is a part of another.
void checkTemperature(const component::Component& component, const log::Log& log, std::size_t first = 0);

/// Returns the force [N] at every sample of a log, by the same stream that the node feeds: the same numbers to the last
/// bit. The component is new and at rest at the log's first displacement, and at the log's temperature if it has one.
/// Shows progress on a terminal. `counters`, if given, receives those of the stream. Throws LogError as checkLog does,
/// if a force is not finite, and if a temperature is outside the range of the component's shift.
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

/// Returns one line for the terminal: samples, duration, range of the force and, with a measured force, the gap.
std::string summary(const std::string& component, const log::Log& log, const Replay& replay,
                    Offset offset = Offset::kept);

/// The names of the log's force and of the other one in a figure, and the quantity on its axis.
struct ForceLabels {
  std::string log = "measured";
  std::string force = "simulated";
  std::string quantity = "force [kN]";
  double factor = 1e-3;  ///< from SI to its unit
};

/// Returns a figure of the last cycles, force over displacement and over time and measured minus simulated force below,
/// and of the whole log, by the smallest and largest residual, or force.
io::Figure replayFigure(const std::string& component, const log::Log& log, const std::vector<double>& force,
                        const ForceLabels& labels = {});

/// Returns a figure of the last cycles of each direction that moves or is loaded: force over coordinate and over time.
io::Figure replayFigure(const std::string& component, const log::PoseLog& log,
                        const std::array<std::vector<double>, 6>& wrench);

}  // namespace rubber_suspension::gap
