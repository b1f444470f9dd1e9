// A law that is realised by Maxwell elements in parallel.
#include "rubber_suspension/element/maxwell_bank.h"

namespace rubber_suspension::element {

double MaxwellBank::step(const Motion& motion, double* memory) const {
  double force = 0.0;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    force += elements_[i].step(motion, memory + i);
  }
  return force;
}

bool MaxwellBank::addTo(BasicLaws& sum) const {
  for (const Maxwell& element : elements_) {
    element.addTo(sum);
  }
  return true;
}

std::optional<std::complex<double>> MaxwellBank::complexStiffness(double omega) const {
  std::complex<double> stiffness = 0.0;
  for (const Maxwell& element : elements_) {
    stiffness += *element.complexStiffness(omega);
  }
  return stiffness;
}

}  // namespace rubber_suspension::element
