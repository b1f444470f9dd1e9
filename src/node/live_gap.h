// The live gap: its size relative to noise, its place and trend, and the errors of the rig. Independent of ROS.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "node/gap_monitor.h"
#include "rubber_suspension/gap/iso18571.h"
#include "rubber_suspension/gap/where.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::node {

struct GapSettings {
  double window = 10.0;  ///< length of the sliding window [s]
  double warn = 0.1;     ///< gap beyond noise at which diagnostics warn [-]
  double error = 0.3;    ///< gap beyond noise at which diagnostics report an error [-]
};

enum class GapLevel { unknown, ok, warn, error };

/// The present gap: RMS of measured minus simulated force, divided by the standard deviation of the measured force.
struct LiveGap {
  bool known = false;      ///< false if there are too few samples or no motion; then only `reason` is set
  std::string reason;      ///< why the gap is not known
  std::int64_t stamp = 0;  ///< stamp of the newest sample [ns]
  double window = 0.0;     ///< time that the samples cover [s]
  std::size_t samples = 0;
  double gap = 0.0;                 ///< gap after removal of errors of the rig within its tolerances [-]
  double gap_as_recorded = 0.0;     ///< gap without this removal [-]
  double noise_floor = 0.0;         ///< gap from the white noise of the measured force alone [-]
  double beyond_noise = 0.0;        ///< sqrt(gap^2 - noise_floor^2), at least 0 [-]
  double trend = 0.0;               ///< rate of change of `gap` [1/s]; 0 until the reports span a window
  gap::Iso18571 iso18571;           ///< rating of the forces with the errors of the rig
  std::array<double, 5> share{};    ///< shares of the squared gap by gap::Quantity; their sum is 1
  std::vector<gap::GapCell> cells;  ///< shares by frequency, amplitude and quantity, largest first
  std::vector<measurement::RigFinding> rig_findings;  ///< errors of the rig in this window

  GapLevel level(const GapSettings& settings) const;
};

/// Selects the force of a sample that is compared with the measured force.
using SimulatedForce = double MatchedSample::*;

/// Returns the gap of one window of matched samples, without trend. Its shares are computed as in the diagnosis.
/// Samples without `force` and samples before the newest time gap (log::EvenSteps) are omitted. Offset, delay, clock
/// error and gain of the force channel are removed if they are within 2 standard deviations of the rig's tolerances.
/// Samples that a channel did not measure do not count. An offset of the displacement remains, because estimating it
/// would require another simulation.
LiveGap measureGap(const std::vector<MatchedSample>& window, const GapSettings& settings,
                   const io::RigTolerances& tolerances = {}, SimulatedForce force = &MatchedSample::simulated);

class GapTracker {
 public:
  explicit GapTracker(const GapSettings& settings, const io::RigTolerances& tolerances = {})
      : settings_(settings), tolerances_(tolerances) {}

  /// Measures the gap of a window and its trend.
  LiveGap update(const std::vector<MatchedSample>& window, SimulatedForce force = &MatchedSample::simulated);

 private:
  struct Point {
    double time;  // [s]
    double gap;
  };

  double trend() const;

  GapSettings settings_;
  io::RigTolerances tolerances_;
  std::deque<Point> history_;
};

}  // namespace rubber_suspension::node
