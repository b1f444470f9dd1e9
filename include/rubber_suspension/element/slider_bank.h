// Banks of Jenkins sliders: friction with memory of all reversals. A single slider is Coulomb friction.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// A spring k in series with a slider, which moves as soon as the spring is deflected by y.
struct JenkinsSlider {
  double yield_displacement;  ///< y [m]
  double stiffness;           ///< k [N/m]

  double maximumForce() const { return stiffness * yield_displacement; }  ///< [N]

  /// Returns the force [N] at a displacement [m]. `slider` is the position of the slider [m], which moves beyond yield.
  double advance(double displacement, double& slider) const {
    if (displacement - slider > yield_displacement) {
      slider = displacement - yield_displacement;
    } else if (slider - displacement > yield_displacement) {
      slider = displacement + yield_displacement;
    }
    return stiffness * (displacement - slider);
  }
};

/// Simulates Jenkins sliders in parallel. The force is rate-independent and obeys Masing's rules: minor loops close,
/// and the settled loop is the backbone (the curve from rest) doubled in both axes. No dead band is needed for noise
/// below the smallest yield displacement. Memory: the position of each slider. Source: W. D. Iwan, J. Appl. Mech. 33
/// (1966) 893-900; G. Masing, Proc. 2nd Int. Congr. Appl. Mech. (1926). Throws nothing: makeElement() checks the
/// values.
class SliderBank : public ParallelElement {
 public:
  explicit SliderBank(std::vector<JenkinsSlider> sliders) : sliders_(std::move(sliders)) {}

  const std::vector<JenkinsSlider>& sliders() const { return sliders_; }

  std::size_t memorySize() const override { return sliders_.size(); }
  double initialise(double displacement, double* memory) const override {
    std::fill(memory, memory + sliders_.size(), displacement);
    return 0.0;
  }
  double step(const Motion& motion, double* memory) const override {
    double force = 0.0;
    for (std::size_t i = 0; i < sliders_.size(); ++i) {
      force += sliders_[i].advance(motion.displacement, memory[i]);
    }
    return force;
  }
  Part part() const override { return Part::friction; }

 private:
  std::vector<JenkinsSlider> sliders_;
};

}  // namespace rubber_suspension::element
