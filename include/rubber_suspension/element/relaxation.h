// Relaxation over one step: exp(-x) and its mean over the step, by a short polynomial where steps are small.
#pragma once

#include <cmath>

namespace rubber_suspension::element {

#include "rubber_suspension/element/relaxation_mean.h"

/// The rest of a relaxing force after a step of x = dt/tau > 0, and its mean over the step, both relative to the
/// force at the begin of the step. Both are within 4e-16 of the exact value, relative to it. Throws nothing.
struct Relaxation {
  double decay;  ///< exp(-x) [-]
  double mean;   ///< (1 - exp(-x))/x [-], tends to 1 as x tends to 0

  /// Steps up to this are `small`; at 1 kHz those of break frequencies up to 55 Hz.
  static constexpr double kSmall = 0.35;

  /// For any step.
  static Relaxation over(double x) { return x <= kSmall ? small(x) : large(x); }

  /// For steps up to kSmall.
  static Relaxation small(double x) {
    const double mean = meanOverSmallStep(x);
    return {1.0 - x * mean, mean};
  }

  static Relaxation large(double x) {
    const double released = -std::expm1(-x);
    return {1.0 - released, released / x};
  }
};

}  // namespace rubber_suspension::element
