// A law that is realised by Maxwell elements in parallel.
#pragma once

#include <vector>

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::element {

/// Sum of Maxwell elements, each stepped exactly for displacement that is linear between samples.
/// A component takes the elements one by one and so computes the coefficients of a step length only once; step() here
/// computes them anew each time. Memory: the force of each element.
class MaxwellBank : public ParallelElement {
 public:
  explicit MaxwellBank(std::vector<Maxwell> elements) : elements_(std::move(elements)) {}

  const std::vector<Maxwell>& elements() const { return elements_; }

  std::size_t memorySize() const override { return elements_.size(); }
  double initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }
  std::optional<std::complex<double>> complexStiffness(double omega) const override;

 private:
  std::vector<Maxwell> elements_;
};

}  // namespace rubber_suspension::element
