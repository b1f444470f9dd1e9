// A law that is realised by Maxwell elements in parallel. Throws nothing: makeElement() checks the values.
#pragma once

#include <vector>

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::element {

/// Sum of Maxwell elements, each stepped exactly for displacement that is linear between samples.
/// As basic laws of a component the elements have their coefficients computed once for a step length; step() here
/// computes them in each step. Memory: the force of each element.
class MaxwellBank : public ParallelElement {
 public:
  explicit MaxwellBank(std::vector<Maxwell> elements) : elements_(std::move(elements)) {}

  const std::vector<Maxwell>& elements() const { return elements_; }

  std::size_t memorySize() const override { return elements_.size(); }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }
  bool addTo(BasicLaws& sum) const override;
  std::optional<std::complex<double>> complexStiffness(double omega) const override;

 private:
  std::vector<Maxwell> elements_;
};

}  // namespace rubber_suspension::element
