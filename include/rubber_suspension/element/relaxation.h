// Relaxation over one step: exp(-x) and its mean over the step, by a short polynomial where steps are small.
#pragma once

#include <cmath>

namespace rubber_suspension {

/// What is left of a relaxing force after a step of x = dt/tau > 0, and its mean over the step, both relative to the
/// force at the begin of the step. Both are within 4e-16 of the exact value, relative to it.
struct Relaxation {
  double decay;  ///< exp(-x) [-]
  double mean;   ///< (1 - exp(-x))/x [-], tends to 1 as x tends to 0

  /// Steps up to this are `small`; at 1 kHz those of break frequencies up to 55 Hz.
  static constexpr double kSmall = 0.35;

  /// For any step.
  static Relaxation over(double x) { return x <= kSmall ? small(x) : large(x); }

  /// The mean is 1 + x P(x). P is the polynomial that agrees with ((1 - exp(-x))/x - 1)/x at nine Chebyshev points of
  /// [0, 0.35]; what it leaves out is below 1e-17 of the mean.
  static Relaxation small(double x) {
    const double mean = smallMean(x);
    return {1.0 - x * mean, mean};
  }

  /// That mean. Several numbers side by side, in a vector type of the compiler, give the same bits as one by one.
  template <class Number>
  static Number smallMean(const Number& x) {
    const Number x2 = x * x;
    const Number x4 = x2 * x2;
    const Number low = (-0.5 + x * 0x1.5555555555479p-3) + x2 * (-0x1.5555555544e97p-5 + x * 0x1.1111110986e3cp-7);
    const Number high = (-0x1.6c16bdf33ee18p-10 + x * 0x1.a0191b55231b5p-13) +
                        x2 * (-0x1.9ff6dcbf864aep-16 + x * 0x1.6eb9cfe67b12bp-19);
    return 1.0 + x * (low + x4 * (high + x4 * -0x1.009a72f2b430cp-22));
  }

  static Relaxation large(double x) {
    const double released = -std::expm1(-x);
    return {1.0 - released, released / x};
  }
};

}  // namespace rubber_suspension
