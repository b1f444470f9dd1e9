// Linear spring. Throws nothing: makeElement() checks the values.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = k z. Valid while the component's static characteristic is straight.
/// Source: Polach (IAVSD 2015), element k0 of every model.
class Spring final : public ParallelElement {
 public:
  explicit Spring(double stiffness /* [N/m] */) : stiffness_(stiffness) {}

  double stiffness() const { return stiffness_; }

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

ElementType springType();

}  // namespace rubber_suspension::element
