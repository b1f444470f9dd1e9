// Banks of Jenkins sliders.
#include "rubber_suspension/element/slider_bank.h"

#include <algorithm>

namespace rubber_suspension::element {

double SliderBank::initialise(double displacement, double* memory) const {
  std::fill(memory, memory + sliders_.size(), displacement);
  return 0.0;
}

double SliderBank::step(const Motion& motion, double* memory) const {
  double force = 0.0;
  for (std::size_t i = 0; i < sliders_.size(); ++i) {
    force += sliders_[i].advance(motion.displacement, memory[i]);
  }
  return force;
}

}  // namespace rubber_suspension::element
