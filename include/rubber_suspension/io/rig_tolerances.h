// Tolerances of a rig: sizes of sensor and clock errors that do not count as faults.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::io {

/// An error of up to this number of standard deviations is within the tolerance of a rig.
inline constexpr double kTolerated = 2.0;

/// Standard deviation of an error that a rig adds to a log. The errors of different logs are independent.
struct RigTolerance {
  double value = 0.0;     ///< in the unit of its row of the table, or a share; 0 if the rig does not have this error
  bool is_share = false;  ///< true: `value` is a share of the quantity that its row of the table states

  /// Returns the tolerance in the unit of its row of the table. `whole` is the quantity to which a share refers.
  double of(double whole) const { return is_share ? value * whole : value; }
};

/// The tolerances of a rig; the defaults are for an unknown bench.
struct RigTolerances {
  RigTolerance force_zero{0.1, true};         ///< offset of the force [N], or share of its range in the log
  RigTolerance displacement_zero{0.1, true};  ///< offset of the displacement [m], or share of its range in the log
  RigTolerance gain{0.005, true};             ///< gain error of the force, a share
  RigTolerance delay{0.5, true};              ///< delay of the force [s], or share of a sampling interval
  RigTolerance clock{1e-4, true};             ///< difference between the clocks of the channels, share of the time
  RigTolerance initial_state{0.1, true};      ///< force from motion before the log [N], or share of the force's range
  RigTolerance slow_noise{0.01, true};        ///< slow noise of the force [N], or share of its standard deviation
};

/// One row of the table from which checks, options and the reference page are made.
struct RigToleranceInfo {
  std::string name;           ///< the key in a component file and in `--rig KEY=VALUE`
  std::string unit;           ///< unit of an absolute value; "1" if only a share is accepted
  std::string share_of;       ///< quantity to which a value in % refers
  std::string documentation;  ///< one line
  RigTolerance RigTolerances::* member;
};

const std::vector<RigToleranceInfo>& rigToleranceTable();

/// Parses text such as "50 N", "0.2 ms" or "0.5 %" for a key. Throws std::invalid_argument, which states the key, the
/// value and the accepted values.
RigTolerance parseRigTolerance(const std::string& key, const std::string& text);

/// Sets the tolerance of an option `--rig KEY=VALUE`. Throws as parseRigTolerance() does.
void setRigTolerance(RigTolerances& tolerances, const std::string& assignment);

/// Returns text from which parseRigTolerance() reads the same number, up to rounding if it is in %.
std::string toString(const RigToleranceInfo& info, const RigTolerance& tolerance);

}  // namespace rubber_suspension::io
