// Linear dashpot.
#include "element/registry.h"
#include "element/smooth_rate.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = c dz/dt with the rate of a displacement that is linear between samples. For a sampled sine the force
/// lags by half a step, which is a phase error of pi f dt. The dynamic stiffness grows with frequency without limit, so
/// the element suits a narrow band only. Source: Polach (IAVSD 2015), element c0 of M1, M3 and M5.
class Dashpot final : public ParallelElement {
 public:
  explicit Dashpot(double damping /* [N s/m] */) : damping_(damping) {}

  double initialise(double /*displacement*/, double* /*memory*/) const override { return 0.0; }
  double step(const Motion& motion, double* /*memory*/) const override {
    return damping_ * (motion.increment / motion.dt);
  }
  Part part() const override { return Part::viscous; }
  bool addTo(BasicLaws& sum) const override {
    sum.damping += damping_;
    return true;
  }

  std::optional<std::complex<double>> complexStiffness(double omega) const override {
    return std::complex<double>(0.0, omega * damping_);
  }

 private:
  double damping_;
};

/// Simulates F = c dz/dt for a displacement that is smooth between samples, without the lag of Dashpot.
class SmoothDashpot final : public SmoothRateDashpot {
 public:
  explicit SmoothDashpot(double damping /* [N s/m] */) : damping_(damping) {}

  double step(const Motion& motion, double* memory) const override { return damping_ * rateAfter(motion, memory); }
  std::optional<std::complex<double>> complexStiffness(double omega) const override {
    return std::complex<double>(0.0, omega * damping_);
  }

 private:
  double damping_;
};

const ElementEntry kDashpotEntry(70, {"dashpot",
                                      "Linear dashpot, F = c dz/dt.",
                                      {{"damping", "N s/m", Role::scale, Range::positive(), "damping constant c"},
                                       {"order", "1", Role::choice, Range::closed(1.0, 2.0),
                                        "order of the difference that gives the rate; 1: displacement linear between "
                                        "samples; 2: smooth displacement, rate without lag",
                                        1.0}},
                                      [](const ElementDescription& description) -> ElementPointer {
                                        const double damping = description.value("damping");
                                        const double order = description.value("order");
                                        if (order == 2.0) {
                                          return std::make_shared<const SmoothDashpot>(damping);
                                        }
                                        if (order != 1.0) {
                                          refuseValue(description.type, "order", order, "1", "1 or 2");
                                        }
                                        return std::make_shared<const Dashpot>(damping);
                                      }});

}  // namespace
}  // namespace rubber_suspension::element
