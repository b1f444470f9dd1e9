// Bouc-Wen hysteresis: rate-independent friction whose loading and unloading curves bend differently.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

// Length of a Runge-Kutta step as a share of the travel over which the rate changes noticeably. The error grows with
// the fourth power of this constant (see BoucWen).
constexpr double kShareOfBend = 0.06;
// Largest |q|^n for which the series in |q|^n is used.
constexpr double kNearZero = 0.125;
// If the rate is below this number, q equals its limit up to rounding.
constexpr double kNoRate = 1e-14;

// Returns the solution of q' = 1 - coefficient q after a travel `way`, which tends to 1/coefficient.
double relaxedTowardsLimit(double q, double coefficient, double way) {
  return coefficient == 0.0 ? q + way : q * std::exp(-coefficient * way) - std::expm1(-coefficient * way) / coefficient;
}

/// Simulates the hysteretic part of the standard form, dh/dt = A dz/dt - beta |dz/dt| |h|^(n-1) h - gamma dz/dt |h|^n,
/// F = h. Its stiffness and damping are a `spring` and a `dashpot` in parallel.
///
/// From rest the force rises with the stiffness A and tends to the limit (A/(beta + gamma))^(1/n). The larger the
/// exponent n, the more sharply the curve bends before this limit. With gamma = -beta there is no limit. Unloading
/// starts with the slope A + (beta - gamma) |h|^n. For beta >= |gamma| the energy h^2/(2 A) never grows by more than
/// the work done, so the law dissipates. Minor loops do not close; `iwan` closes them.
///
/// The step is exact for n = 1. Otherwise it consists of Runge-Kutta steps that are short compared to the bend; its
/// error is below 1e-6 (A/beta)^(1/n) for n up to 20 at any step length. Memory: the force. Source: Y.-K. Wen, J. Eng.
/// Mech. Div. ASCE 102 (1976) 249-263; as a model of rubber: Kim et al., reference 11 of Polach (IAVSD 2015);
/// dissipation: M. Ismail, F. Ikhouane and J. Rodellar, Arch. Comput. Methods Eng. 16 (2009) 161-188.
class BoucWen final : public ParallelElement {
 public:
  BoucWen(double stiffness /* A [N/m] */, double beta /* [N^(1-n)/m] */, double gamma /* [N^(1-n)/m] */,
          double exponent /* n [-] */)
      : stiffness_(stiffness),
        exponent_(exponent),
        asymmetry_(gamma / beta),
        scale_(std::pow(stiffness / beta, 1.0 / exponent)),
        limit_(asymmetry_ > -1.0 ? std::pow(1.0 + asymmetry_, -1.0 / exponent)
                                 : std::numeric_limits<double>::infinity()),
        near_(std::pow(kNearZero, 1.0 / exponent)) {}

  std::size_t memorySize() const override { return 1; }
  double step(const Motion& motion, double* memory) const override {
    if (motion.increment == 0.0) {
      return memory[0];
    }
    const double direction = std::copysign(1.0, motion.increment);
    const double q = std::clamp(direction * memory[0] / scale_, -limit_, limit_);
    const double way = std::abs(motion.increment) * stiffness_ / scale_;
    return memory[0] = direction * scale_ * (exponent_ == 1.0 ? afterOfExponentOne(q, way) : after(q, way));
  }
  Part part() const override { return Part::friction; }

 private:
  // Returns the derivative q' = 1 - |q|^n (sign(q) + gamma/beta) with respect to the travel in units of scale_/A. q is
  // the force divided by scale_, positive in the direction of the travel.
  double rate(double q) const { return 1.0 - std::pow(std::abs(q), exponent_) * (std::copysign(1.0, q) + asymmetry_); }

  // Returns the signed travel from q = 0 to a small q, which is the integral of 1/q', computed by a series in |q|^n
  // because q' is not smooth at 0.
  double wayFromZero(double q) const {
    const double ratio = (asymmetry_ + std::copysign(1.0, q)) * std::pow(std::abs(q), exponent_);
    double sum = 1.0;
    double power = ratio;
    for (int k = 1; k < 60 && std::abs(power) > 1e-17; ++k, power *= ratio) {
      sum += power / (exponent_ * k + 1.0);
    }
    return q * sum;
  }

  // Inverts wayFromZero() by Newton's method: returns q after a travel `way` from q = 0.
  double nearZero(double way) const {
    double q = std::clamp(way, -near_, near_);
    for (int i = 0; i < 8; ++i) {
      const double change = (way - wayFromZero(q)) * rate(q);
      q += change;
      if (std::abs(change) < 1e-16) {
        break;
      }
    }
    return q;
  }

  double rungeKutta(double q, double way) const {
    const double first = rate(q);
    const double second = rate(q + 0.5 * way * first);
    const double third = rate(q + 0.5 * way * second);
    const double fourth = rate(q + way * third);
    return q + way / 6.0 * (first + 2.0 * (second + third) + fourth);
  }

  double afterOfExponentOne(double q, double way) const {
    if (q < 0.0) {
      const double unloading = 1.0 - asymmetry_;
      const double to_zero = unloading > 0.0 ? std::log1p(-unloading * q) / unloading : -q;
      if (way < to_zero) {
        return relaxedTowardsLimit(q, unloading, way);
      }
      way -= to_zero;
      q = 0.0;
    }
    return relaxedTowardsLimit(q, 1.0 + asymmetry_, way);
  }

  double after(double q, double way) const {
    while (way > 0.0) {
      if (q >= -near_ && q < near_) {
        const double begin = wayFromZero(q);
        const double end = wayFromZero(near_);
        if (begin + way < end) {
          return nearZero(begin + way);
        }
        way -= end - begin;
        q = near_;
        continue;
      }
      const double slope = rate(q);
      if (std::abs(slope) < kNoRate) {
        break;
      }
      const double curved = std::max(1.0, std::abs(1.0 - slope));
      const double step = std::min(way, kShareOfBend * std::max(1.0, std::abs(q)) / (exponent_ * curved));
      q = rungeKutta(q, step);
      way -= step;
    }
    return q;
  }

  double stiffness_;
  double exponent_;
  double asymmetry_;  // gamma/beta [-]
  double scale_;      // (A/beta)^(1/n) [N]
  double limit_;      // limit of q after a long travel in one direction [-]; infinite for gamma = -beta
  double near_;       // largest |q| for which the series at zero is used [-]
};

const ElementEntry kBoucWenEntry(
    240, {"bouc_wen",
          "Bouc-Wen hysteresis, dh/dt = A dz/dt - beta |dz/dt| |h|^(n-1) h - gamma dz/dt |h|^n; spring and dashpot are "
          "separate elements.",
          {{"stiffness", "N/m", Role::shape, Range::positive(), "stiffness A at the start of motion from rest"},
           {"beta", "1/m", Role::shape, Range::positive(), "coefficient beta; its unit is N^(1-n)/m if n is not 1"},
           {"gamma", "1/m", Role::shape, Range::any(),
            "coefficient gamma, at most beta in magnitude; its unit is N^(1-n)/m if n is not 1"},
           {"exponent", "1", Role::choice, Range::closed(1.0, 20.0),
            "exponent n; the larger, the sharper the loop bends", 1.0}},
          [](const ElementDescription& description) -> ElementPointer {
            const double beta = description.value("beta");
            const double gamma = description.value("gamma");
            if (std::abs(gamma) > beta) {
              refuseValue(description.type, "gamma", gamma, "1/m",
                          fmt::format("in [{:g}, {:g}], because |gamma| > beta would create energy", -beta, beta));
            }
            return std::make_shared<const BoucWen>(description.value("stiffness"), beta, gamma,
                                                   description.value("exponent"));
          }});

}  // namespace
}  // namespace rubber_suspension::element
