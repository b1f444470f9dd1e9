// One implicit step of a flow that a power of the force drives.
#pragma once

#include <algorithm>
#include <cmath>

namespace rubber_suspension::element {

// Solves the equation of flowRoot() for m > 1 by Newton steps from above.
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

/// The root x >= 0 of x + b x^m = r for b >= 0, m > 0 and r >= 0: what is left of a force r after a step over which its
/// flow is b x^m. In closed form for m = 1/2, 1 and 2, by Newton's method else, which converges monotonically since the
/// function is convex (in x^m where m < 1). To rounding.
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
