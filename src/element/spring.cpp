// Linear spring.
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = k z. Validity: a linear static characteristic. Source: Polach (IAVSD 2015), element k0 of every model.
class Spring final : public ParallelElement {
 public:
  explicit Spring(double stiffness /* [N/m] */) : stiffness_(stiffness) {}

  double initialise(double displacement, double* /*memory*/) const override { return stiffness_ * displacement; }
  double step(const Motion& motion, double* /*memory*/) const override { return stiffness_ * motion.displacement; }
  Part part() const override { return Part::elastic; }
  bool addTo(BasicLaws& sum) const override {
    sum.stiffness += stiffness_;
    return true;
  }
  std::optional<std::complex<double>> complexStiffness(double /*omega*/) const override { return stiffness_; }

 private:
  double stiffness_;
};

const ElementEntry kSpringEntry(10, {"spring",
                                     "Linear spring, F = k z.",
                                     {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k"}},
                                     makes<Spring>("stiffness")});

}  // namespace
}  // namespace rubber_suspension::element
