// Simulates a component on a recorded log.
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

/// Throws LogError with the number of the first such sample if a temperature is outside the range of the component's
/// shift. `first` is the index of the first sample if the log is a part of another log.
void checkTemperature(const component::Component& component, const log::Log& log, std::size_t first = 0);

/// Returns the force [N] at every sample of a log. The force is computed by the same stream as in the node, and equals
/// the force of the node to the last bit. The component is new and at rest at the first displacement and temperature of
/// the log. Shows progress on a terminal. `counters`, if given, receives the counters of the stream. Throws LogError as
/// checkLog does, if a force is not finite, and if a temperature is outside the range of the component's shift.
std::vector<double> simulateLog(const component::Component& component, const log::Log& log,
                                component::StreamCounters* counters = nullptr);

struct Replay {
  std::vector<double> force;  ///< [N], one per sample
  std::uint64_t bridged = 0;  ///< number of time gaps longer than max_gap of the stream
};

/// Simulates a log. Throws as simulateLog() does.
Replay replay(const component::Component& component, const log::Log& log);

/// States whether the mean difference of the forces is kept in a gap or removed from it.
enum class Offset { kept, removed };

/// Returns one line for the terminal: samples, duration, range of the force and, if a force was measured, the gap.
std::string summary(const std::string& component, const log::Log& log, const Replay& replay,
                    Offset offset = Offset::kept);

/// Names of the force of the log and of the simulated force in a figure, and the quantity on the axis.
struct ForceLabels {
  std::string log = "measured";
  std::string force = "simulated";
  std::string quantity = "force [kN]";
  double factor = 1e-3;  ///< factor from SI to the unit of `quantity`
};

/// Returns a figure with four panels. Three show the last cycles: force over displacement, force over time, and
/// measured minus simulated force over time (or displacement over time, if no force was measured). The fourth shows the
/// smallest and largest residual, or force, in stretches of the whole log.
io::Figure replayFigure(const std::string& component, const log::Log& log, const std::vector<double>& force,
                        const ForceLabels& labels = {});

/// Returns a figure of the last cycles of each direction that moves or is loaded, over the coordinate and over time.
io::Figure replayFigure(const std::string& component, const log::PoseLog& log,
                        const std::array<std::vector<double>, 6>& wrench);

}  // namespace rubber_suspension::gap
