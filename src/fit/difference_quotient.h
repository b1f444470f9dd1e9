// Derivatives of simulated forces by difference quotients: the one place that chooses their steps and sides.
#pragma once

#include <functional>
#include <optional>

#include "fit/free_in_log.h"
#include "gap/simulate.h"

namespace rubber_suspension::fit {

/// Of the logarithm of a parameter of a model, or of a number of a law: truncation 1e-4 and rounding 1e-12, relative.
constexpr double kLogarithmStep = 1e-4;

/// Of the scale of a term at work, over its typical one. A term at nothing moves by all of the typical scale, so that
/// a fit sees what it would come to.
constexpr double kScaleStep = 0.02;

/// Of a coordinate of the search of `estimate`, whose gradient has to vanish at the optimum to more digits: truncation
/// 1e-6 and rounding 1e-10, both relative.
constexpr double kSearchStep = 1e-6;

/// The step that a quotient is over: this one, or the same to the other side, or 0 where `hasForce` tells of neither.
double takenStep(double step, const std::function<bool(double by)>& hasForce);

/// (F(x + step) - F(x))/step by takenStep(); 0 where that is 0: the unknown cannot move. `base`: F(x). `moved`:
/// F(x + by) [N].
ForceColumn quotient(const gap::Forces& base, double step,
                     const std::function<std::optional<gap::Forces>(double by)>& moved);

}  // namespace rubber_suspension::fit
