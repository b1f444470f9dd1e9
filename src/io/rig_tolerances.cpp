// Tolerances of a rig: their table and their parser.
#include "rubber_suspension/io/rig_tolerances.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "io/named_row.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::io {
namespace {

constexpr double kMostShare = 0.5;  // limit for a gain or a clock; with a larger error a channel would be useless

std::string acceptedTolerance(const RigToleranceInfo& info) {
  const std::string share = fmt::format("a share of {} in %", info.share_of);
  return info.unit == "1" ? fmt::format("{} or as a number, from 0 to {:g} %", share, 100.0 * kMostShare)
                          : fmt::format("a number of at least 0 in {}, text with such a unit, or {}", info.unit, share);
}

const RigToleranceInfo& findRow(const std::string& key) {
  return namedRow(rigToleranceTable(), key, "not a tolerance of a rig");
}

}  // namespace

const std::vector<RigToleranceInfo>& rigToleranceTable() {
  static const std::vector<RigToleranceInfo> table = {
      {"force_zero", "N", "the force's range in the log", "zero error of the force, different in each log",
       &RigTolerances::force_zero},
      {"displacement_zero", "m", "the displacement's range in the log",
       "zero error of the displacement, different in each log", &RigTolerances::displacement_zero},
      {"gain", "1", "the force", "gain error of the force channel relative to the displacement channel",
       &RigTolerances::gain},
      {"delay", "s", "a sampling interval", "delay of the force channel relative to the displacement channel",
       &RigTolerances::delay},
      {"clock", "1", "the time", "difference between the clocks of force and displacement, if they are separate",
       &RigTolerances::clock},
      {"initial_state", "N", "the force's range in the log",
       "force that remains from motion before the log, if the log starts in motion", &RigTolerances::initial_state},
      {"slow_noise", "N", "the force's standard deviation in the log",
       "noise of the force that is slower than the motion, and drift of the force's zero", &RigTolerances::slow_noise},
  };
  return table;
}

RigTolerance parseRigTolerance(const std::string& key, const std::string& text) {
  const RigToleranceInfo& info = findRow(key);
  const std::string trimmed = log::trimmed(text);
  RigTolerance tolerance;
  tolerance.is_share = info.unit == "1" || (!trimmed.empty() && trimmed.back() == '%');
  try {
    tolerance.value = log::parseQuantity(text, tolerance.is_share ? "1" : info.unit);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("{}: {}: {}; accepted: {}", key, log::quoted(text), error.what(), acceptedTolerance(info)));
  }
  if (!(tolerance.value >= 0.0) || !std::isfinite(tolerance.value) ||
      (info.unit == "1" && tolerance.value > kMostShare)) {
    throw std::invalid_argument(
        fmt::format("{}: {} is out of range; accepted: {}", key, log::quoted(text), acceptedTolerance(info)));
  }
  return tolerance;
}

void setRigTolerance(RigTolerances& tolerances, const std::string& assignment) {
  const std::size_t equal = assignment.find('=');
  if (equal == std::string::npos) {
    throw std::invalid_argument(
        fmt::format("{}: '=' is missing; accepted: KEY=VALUE, such as force_zero=50 N", log::quoted(assignment)));
  }
  const std::string key = log::trimmed(assignment.substr(0, equal));
  tolerances.*findRow(key).member = parseRigTolerance(key, assignment.substr(equal + 1));
}

std::string toString(const RigToleranceInfo& info, const RigTolerance& tolerance) {
  if (info.unit == "1" || !tolerance.is_share) {
    return fmt::format("{}", tolerance.value);
  }
  return fmt::format("{} %", tolerance.value * 100.0);
}

}  // namespace rubber_suspension::io
