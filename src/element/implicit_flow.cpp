// Root of an implicit flow.
#include "rubber_suspension/element/implicit_flow.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::element {
namespace {

// For m > 1, from above.
double newton(double r, double b, double m) {
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

}  // namespace

double flowRoot(double r, double b, double m) {
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
  return m > 1.0 ? newton(r, b, m) : std::pow(newton(r / b, 1.0 / b, 1.0 / m), 1.0 / m);
}

}  // namespace rubber_suspension::element
