// Roots of a series balance for any test piece.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubber_suspension::component {

struct RootSample {
  double position;
  double value;
};

/// Returns the root between two samples of opposite signs by the method of Anderson and Bjorck (BIT 13, 1973), a secant
/// method that reduces the value of a sample that is kept. Ends if the value or the bracket is as small as rounding.
template <class Function>
double rootBetween(Function function, RootSample stays, RootSample latest) {
  constexpr double kRounding = 2.0 * std::numeric_limits<double>::epsilon();
  constexpr int kMostSteps = 100;
  for (int i = 0; i < kMostSteps; ++i) {
    const double slope = (latest.value - stays.value) / (latest.position - stays.position);
    const double position = latest.position - latest.value / slope;
    if (position == latest.position || position == stays.position) {
      return position;
    }
    const RootSample next{position, function(position)};
    if (!(std::abs(next.value) > kRounding * std::abs(position))) {
      return position;
    }
    if (next.value * latest.value < 0.0) {
      stays = latest;
    } else {
      const double share = 1.0 - next.value / latest.value;
      stays.value *= share > 0.0 ? share : 0.5;
    }
    latest = next;
  }
  return latest.position;
}

/// Returns the root of mismatch(z) = z + u(F(z)) - z_path nearest to the guess. If the slope of the mismatch is at
/// least `least_slope`, the root lies between the guess and the guess minus mismatch/least_slope. Otherwise the search
/// continues with steps that double. Returns NaN if there is no root, that is, if the test piece is unstable.
template <class Mismatch>
double solveSeriesBalance(Mismatch mismatch, double guess, double least_slope = 1.0) {
  constexpr int kWidenings = 60;
  const double at_guess = mismatch(guess);
  if (at_guess == 0.0 || !std::isfinite(at_guess)) {
    return guess;
  }
  double other = guess - at_guess / least_slope;
  double at_other = mismatch(other);
  // Equal signs may be due to rounding if the mismatch is as small as rounding.
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * (std::abs(guess) + std::abs(other));
  for (int i = 0; i < kWidenings && at_other * at_guess > 0.0 && std::abs(at_other) > rounding; ++i) {
    other = guess + 2.0 * (other - guess);
    at_other = mismatch(other);
  }
  if (std::abs(at_other) <= rounding) {
    return other;
  }
  if (!(at_other * at_guess < 0.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return rootBetween(mismatch, {guess, at_guess}, {other, at_other});
}

/// Returns the displacement of a test piece behind an open contact: the root of force(z), which is its force minus that
/// of the contact and has the wrong sign at `wrong`. `before`, the displacement before the step, is near the root.
template <class Force>
double solveFreeLength(Force force, double wrong, double force_there, double before) {
  constexpr double kLeast = 1e-12;  // [m]
  const double stiffness = std::abs(force_there) / std::max(std::abs(wrong - before), kLeast);
  return solveSeriesBalance([&](double z) { return force(z) / stiffness; }, wrong);
}

}  // namespace rubber_suspension::component
