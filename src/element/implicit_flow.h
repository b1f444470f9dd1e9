// One implicit step of a viscous flow whose rate is a power of the force.
#pragma once

#include <algorithm>
#include <cmath>

namespace rubber_suspension::element {

// Solves the equation of flowRoot() for m > 1 by Newton's method, which starts above the root.
inline double flowRootByNewton(double r, double b, double m) {
  constexpr int kMostSteps = 60;
  double x = std::min(r, std::pow(r / b, 1.0 / m));
  for (int i = 0; i < kMostSteps; ++i) {
    const double power = b * std::pow(x, m - 1.0);
    const double next = x - (x + power * x - r) / (1.0 + m * power);
    if (!(next < x)) {
      break;
    }
    x = next;
  }
  return x;
}

/// Returns the root x >= 0 of x + b x^m = r for b >= 0, m > 0 and r >= 0: r is the force that a step without flow would
/// give, x the force after an implicit step with the flow b x^m. The solution is a closed form for m = 1/2, 1 and 2.
/// Otherwise Newton's method converges monotonically, since the function is convex in x or, for m < 1, in x^m. The
/// result is accurate up to rounding.
inline double flowRoot(double r, double b, double m) {
  if (!(r > 0.0) || b == 0.0) {
    return std::max(r, 0.0);
  }
  if (m == 1.0) {
    return r / (1.0 + b);
  }
  if (m == 2.0) {
    return 2.0 * r / (1.0 + std::sqrt(1.0 + 4.0 * b * r));
  }
  if (m == 0.5) {
    const double root = 2.0 * r / (b + std::sqrt(b * b + 4.0 * r));
    return root * root;
  }
  return m > 1.0 ? flowRootByNewton(r, b, m) : std::pow(flowRootByNewton(r / b, 1.0 / b, 1.0 / m), 1.0 / m);
}

}  // namespace rubber_suspension::element
