// A finding about the rig, as reports state it. Throws nothing.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace rubber_suspension::measurement {

/// Names of findings, as reports write them.
namespace finding {
inline constexpr const char* kForceZero = "force_zero";
inline constexpr const char* kDisplacementZero = "displacement_zero";
inline constexpr const char* kRunningStart = "running_start";
inline constexpr const char* kSensorGain = "sensor_gain";
inline constexpr const char* kDelay = "delay";
inline constexpr const char* kClock = "clock";
inline constexpr const char* kSpikes = "spikes";
inline constexpr const char* kHeldValues = "held_values";
inline constexpr const char* kSaturation = "saturation";
inline constexpr const char* kColouredNoise = "coloured_noise";
inline constexpr const char* kLine = "line";
inline constexpr const char* kSign = "sign";
inline constexpr const char* kUnitFactor = "unit_factor";
inline constexpr const char* kSwappedColumns = "swapped_columns";
inline constexpr const char* kOtherComponent = "other_component";
inline constexpr const char* kRectified = "rectified";
inline constexpr const char* kContactSide = "contact_side";
inline constexpr const char* kConstant = "constant";
inline constexpr const char* kPeakToPeak = "peak_to_peak";
inline constexpr const char* kDrift = "drift";
inline constexpr const char* kTooShort = "too_short";
}  // namespace finding

/// One error of a rig in one log.
struct RigFinding {
  std::string log;
  std::string finding;                             ///< one of the names above
  double value = 0.0;                              ///< size of the error, in `unit`
  std::array<double, 2> interval_95 = {0.0, 0.0};  ///< interval of `value`; both limits are `value` for a count
  std::string unit;                                ///< "1" for shares, factors and counts
  bool fatal = false;             ///< true for a wrong sign, unit, column or component, after which no effect is named
  bool beyond_tolerance = false;  ///< true if beyond 2 standard deviations of the rig's tolerances
  std::string text;               ///< one sentence that states evidence and correction
  double frequency = 0.0;         ///< frequency of a spectral line [Hz]; 0 for other findings
};

/// Returns true if one of the findings is fatal.
bool anyFatal(const std::vector<RigFinding>& findings);

}  // namespace rubber_suspension::measurement
