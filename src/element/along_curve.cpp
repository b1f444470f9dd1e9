// Maxwell elements, dashpots and sliders whose coefficients depend on the displacement: rubber under a preload.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "element/position_table.h"
#include "element/registry.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/iwan.h"
#include "rubber_suspension/element/relaxation.h"
#include "rubber_suspension/element/slider_bank.h"

namespace rubber_suspension::element {
namespace {

// Returns (1 - (1 + x) exp(-x))/x^2, the mean of s exp(-x s) for s from 0 to 1, which tends to 1/2 as x tends to 0.
double momentOverStep(double x, const Relaxation& relaxation) {
  constexpr double kSeries = 0.05;  // for larger x, the difference has 14 digits
  return x > kSeries ? (relaxation.mean - relaxation.decay) / x
                     : 1.0 / 2 - x * (1.0 / 3 - x * (1.0 / 8 - x * (1.0 / 30 - x * (1.0 / 144 - x * (1.0 / 840)))));
}

ParameterInfo pointsParameter() {
  return {"displacement",
          "m",
          Role::choice,
          Range::any(),
          "displacement of each point, not decreasing; beyond the end points the values are constant",
          std::nullopt,
          true};
}

PositionTable tableOf(const ElementDescription& description, const std::string& name) {
  return {description.type, description.list("displacement"), name, description.list(name)};
}

// Returns k_r exp(b ((z/z_r)^2 - 1)) at points that are so dense that interpolation errs by at most 2 % for b = 10.
PositionTable grownTable(const ElementDescription& description, double growth, int side) {
  constexpr int kPointsOfSide = 48;
  const std::vector<double>& reach = description.list("displacement");
  const std::vector<double>& stiffness = description.list("stiffness");
  if (reach.size() != 1 || stiffness.size() != 1 || !(reach.front() > 0.0)) {
    throw std::invalid_argument(
        fmt::format("{}.growth: is {:g} with {} displacements and {} stiffness values; accepted: one displacement "
                    "greater than 0 and one stiffness, or no growth",
                    description.type, growth, reach.size(), stiffness.size()));
  }
  std::vector<double> displacement;
  std::vector<double> grown;
  for (int i = -kPointsOfSide; i <= kPointsOfSide; ++i) {
    const double share = static_cast<double>(i) / kPointsOfSide;
    displacement.push_back(share * reach.front());
    grown.push_back(stiffness.front() * std::exp(growth * ((side * i < 0 ? 0.0 : share * share) - 1.0)));
  }
  return {description.type, std::move(displacement), "stiffness", std::move(grown)};
}

/// Simulates dF/dt = k(z) dz/dt - F/tau, tau = 1/(2 pi f_b), with a stiffness that is linear between points of the
/// displacement and constant outside them. If k is proportional to the slope of the static curve, the loss angle of
/// small oscillations does not depend on the preload, as in rubber. With U, the integral of k over z, and w = U(z) - F,
/// the stored energy is the integral of U - w from the point where U = w; for k > 0 this energy never grows by more
/// than the work done. The step is exact for a displacement that is linear between samples, because it is split at the
/// points. Memory: force. Validity: one relaxation time at all preloads. Source: A. Ledesma et al., UM-MEAM-95-05
/// (1995), for a branch of this structure with a nonlinear elastic function.
///
/// With a `growth` b, a formula replaces the points: k(z) = k_r exp(b ((z/z_r)^2 - 1)) up to the single displacement
/// z_r, and constant beyond. With a `side`, the stiffness on the other side is k(0). So the elastic force grows
/// exponentially with strain and relaxes at the same rate at any strain. Source: quasi-linear viscoelasticity, Y. C.
/// Fung, Biomechanics (Springer 1981), ch. 7.
class MaxwellAlongCurve final : public ParallelElement {
 public:
  MaxwellAlongCurve(PositionTable stiffness /* k(z) [N/m] */, double break_frequency /* f_b [Hz] */)
      : stiffness_(std::move(stiffness)), rate_(2.0 * kPi * break_frequency) {}

  std::size_t memorySize() const override { return 1; }
  double step(const Motion& motion, double* memory) const override {
    double force = memory[0];
    if (motion.increment == 0.0) {
      return memory[0] = force * Relaxation::over(motion.dt * rate_).decay;
    }
    stiffness_.along(motion.displacement - motion.increment, motion.displacement,
                     [&](double begin, double end, double stiffness_before, double stiffness_after) {
                       const double x = motion.dt * rate_ * ((end - begin) / motion.increment);
                       const Relaxation relaxation = Relaxation::over(x);
                       const double gain = stiffness_after * relaxation.mean -
                                           (stiffness_after - stiffness_before) * momentOverStep(x, relaxation);
                       force = relaxation.decay * force + gain * (end - begin);
                     });
    return memory[0] = force;
  }
  Part part() const override { return Part::viscous; }

 private:
  PositionTable stiffness_;
  double rate_;  // 1/tau [1/s]
};

/// Simulates F = c(z) dz/dt, averaged over the step, with a damping that is linear between points as in
/// MaxwellAlongCurve, whose source also applies.
class DashpotAlongCurve final : public ParallelElement {
 public:
  explicit DashpotAlongCurve(PositionTable damping /* c(z) [N s/m] */) : damping_(std::move(damping)) {}

  double step(const Motion& motion, double* /*memory*/) const override {
    double impulse = 0.0;
    damping_.along(motion.displacement - motion.increment, motion.displacement,
                   [&](double begin, double end, double damping_before, double damping_after) {
                     impulse += 0.5 * (damping_before + damping_after) * (end - begin);
                   });
    return impulse / motion.dt;
  }
  Part part() const override { return Part::viscous; }

 private:
  PositionTable damping_;
};

/// Simulates a bank of Jenkins sliders whose force is multiplied by a factor b(z) >= 0, which is linear between points
/// as in MaxwellAlongCurve. The sliders slide at the same displacements at every preload. A slider at the position s
/// stores the integral of b k (z - s) over z from s and dissipates energy while it slides. Sources: see SliderBank.
class SlidersAlongCurve final : public ParallelElement {
 public:
  SlidersAlongCurve(std::vector<JenkinsSlider> sliders, PositionTable factor /* b(z) [-] */)
      : bank_(std::move(sliders)), factor_(std::move(factor)) {}

  std::size_t memorySize() const override { return bank_.memorySize(); }
  double initialise(double displacement, double* memory) const override {
    return bank_.initialise(displacement, memory);
  }

  double step(const Motion& motion, double* memory) const override {
    return factor_.at(motion.displacement) * bank_.step(motion, memory);
  }
  Part part() const override { return Part::friction; }

 private:
  SliderBank bank_;
  PositionTable factor_;
};

const ElementEntry kMaxwellAlongCurveEntry(
    170, {"maxwell_along_curve",
          "Maxwell element whose stiffness depends on the displacement, dF/dt = k(z) dz/dt - 2 pi f_b F.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k at each point of the curve", std::nullopt,
            true},
           pointsParameter(),
           {"break_frequency", "Hz", Role::shape, Range::positive(), "break frequency f_b"},
           {"growth", "1", Role::shape, Range::closed(0.0, 20.0),
            "growth b for a single point z_r: k(z) = stiffness exp(b ((z/z_r)^2 - 1)) up to z_r", 0.0},
           {"side", "1", Role::choice, Range::closed(-1.0, 1.0),
            "1: the stiffness grows with z > 0 only; -1: with z < 0 only; 0: with both", 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            const double growth = description.value("growth");
            const int side = sideOf(description, "z");
            return std::make_shared<const MaxwellAlongCurve>(
                growth > 0.0 ? grownTable(description, growth, side) : tableOf(description, "stiffness"),
                description.value("break_frequency"));
          }});

const ElementEntry kDashpotAlongCurveEntry(180, {"dashpot_along_curve",
                                                 "Dashpot whose damping depends on the displacement, F = c(z) dz/dt.",
                                                 {pointsParameter(),
                                                  {"damping", "N s/m", Role::scale, Range::positive(),
                                                   "damping c at each point of the curve", std::nullopt, true}},
                                                 [](const ElementDescription& description) -> ElementPointer {
                                                   return std::make_shared<const DashpotAlongCurve>(
                                                       tableOf(description, "damping"));
                                                 }});

const ElementEntry kSlidersAlongCurveEntry(
    190,
    {"sliders_along_curve",
     "Friction sliders whose force depends on the displacement: the force of iwan_table times a factor b(z).",
     {pointsParameter(),
      {"factor", "1", Role::reference, Range::nonNegative(), "factor b at each point of the curve", std::nullopt, true},
      {"yield_displacement", "m", Role::shape, Range::positive(), "displacement at which each slider starts to slide",
       std::nullopt, true},
      {"stiffness", "N/m", Role::scale, Range::positive(), "stiffness of each slider", std::nullopt, true}},
     [](const ElementDescription& description) -> ElementPointer {
       return std::make_shared<const SlidersAlongCurve>(slidersFromTable(description), tableOf(description, "factor"));
     }});

}  // namespace
}  // namespace rubber_suspension::element
