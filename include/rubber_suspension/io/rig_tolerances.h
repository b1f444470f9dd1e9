// Changes that a rig may make to a log without a fault: tolerances of its sensors and its clock.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::io {

/// Up to so many standard deviations of its tolerance, what a rig does is nobody's fault.
inline constexpr double kTolerated = 2.0;

/// Standard deviation of something that a rig adds to a log, new in each log.
struct RigTolerance {
  double value = 0.0;     ///< in the unit of its row, or as a share; 0: the rig does not do it
  bool is_share = false;  ///< of the quantity in the row of the table

  /// In the unit of its row, where a share is one of `whole`.
  double of(double whole) const { return is_share ? value * whole : value; }
};

/// The tolerances of a rig; a default is that of a bench of which nothing is known.
struct RigTolerances {
  RigTolerance force_zero{0.1, true};         ///< [N], or share of the force's range in the log
  RigTolerance displacement_zero{0.1, true};  ///< [m], or share of the displacement's range in the log
  RigTolerance gain{0.005, true};             ///< share of the force
  RigTolerance delay{0.5, true};              ///< of the force behind the displacement [s], or share of a sample
  RigTolerance clock{1e-4, true};             ///< by which the clocks of the channels differ, share of the time
  RigTolerance initial_state{0.1, true};      ///< [N], or share of the force's range, where a log starts in motion
  RigTolerance slow_noise{0.01, true};        ///< [N], or share of the force's standard deviation
};

/// One row of the table that checks, options and reference page follow.
struct RigToleranceInfo {
  std::string name;           ///< the key in a component file and in `--rig KEY=VALUE`
  std::string unit;           ///< of an absolute value; "1" where there are shares only
  std::string share_of;       ///< what a value in % is a share of
  std::string documentation;  ///< one line
  RigTolerance RigTolerances::* member;
};

const std::vector<RigToleranceInfo>& rigToleranceTable();

/// Text such as "50 N", "0.2 ms" or "0.5 %" for a key. Throws std::invalid_argument that names key, value and what is
/// accepted.
RigTolerance parseRigTolerance(const std::string& key, const std::string& text);

/// Applies `--rig KEY=VALUE`. Throws as parseRigTolerance() does.
void setRigTolerance(RigTolerances& tolerances, const std::string& assignment);

/// Text that parseRigTolerance() reads back to the same number; a share to the last digit but one.
std::string toString(const RigToleranceInfo& info, const RigTolerance& tolerance);

}  // namespace rubber_suspension::io
