// A law that is realised by Maxwell elements in parallel.
#pragma once

#include <vector>

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::element {

/// Simulates Maxwell elements in parallel, each exactly for a displacement that is linear between samples. A component
/// computes the coefficients of the elements once per step length, because addTo() adds the elements as basic laws.
/// step() computes the coefficients in every step. Memory: the force of each element.
class MaxwellBank : public ParallelElement {
 public:
  explicit MaxwellBank(std::vector<Maxwell> elements) : elements_(std::move(elements)) {}

  std::size_t memorySize() const override { return elements_.size(); }
  double step(const Motion& motion, double* memory) const override {
    double force = 0.0;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      force += elements_[i].step(motion, memory + i);
    }
    return force;
  }
  Part part() const override { return Part::viscous; }
  bool addTo(BasicLaws& sum) const override {
    for (const Maxwell& element : elements_) {
      element.addTo(sum);
    }
    return true;
  }

  std::optional<std::complex<double>> complexStiffness(double omega) const override {
    std::complex<double> stiffness = 0.0;
    for (const Maxwell& element : elements_) {
      stiffness += *element.complexStiffness(omega);
    }
    return stiffness;
  }

 private:
  std::vector<Maxwell> elements_;
};

}  // namespace rubber_suspension::element
