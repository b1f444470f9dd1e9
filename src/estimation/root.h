// Roots of functions of one variable.
#pragma once

#include <boost/math/tools/roots.hpp>
#include <optional>

namespace rubber_suspension::estimation {

/// Returns the root between `low` and `high`, where the function has values of opposite signs, to `bits` bits.
template <class Function>
double rootBetween(Function function, double low, double high, double at_low, double at_high, int bits = 50) {
  boost::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(function, low, high, at_low, at_high,
                                                         boost::math::tools::eps_tolerance<double>(bits), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

/// Returns the lowest root that a scan in `steps` even steps finds; nullopt if none. NaN is no change of sign.
template <class Function>
std::optional<double> lowestRoot(Function function, double low, double high, int steps, int bits = 50) {
  double before = low;
  double at_before = function(before);
  for (int i = 1; i <= steps; ++i) {
    const double now = low + (high - low) * i / steps;
    const double at_now = function(now);
    if (at_before * at_now <= 0.0) {
      return rootBetween(function, before, now, at_before, at_now, bits);
    }
    before = now;
    at_before = at_now;
  }
  return std::nullopt;
}

/// Returns the root of an increasing function of a positive variable, which may be decades away from 1.
template <class Function>
double increasingRoot(Function function) {
  boost::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::bracket_and_solve_root(
      function, 1.0, 8.0, true, boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace rubber_suspension::estimation
