// Maxwell element: spring and dashpot in series. Throws nothing: makeElement() checks the values.
#pragma once

#include <cmath>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/element.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {

#include "rubber_suspension/element/maxwell_force.h"

/// Coefficients of the exact step of a Maxwell element for one step length.
struct MaxwellStep {
  double decay;  ///< e = exp(-dt/tau) [-]
  double gain;   ///< k tau (1 - e)/dt [N/m], tends to k as dt tends to 0

  MaxwellStep(double stiffness, const Relaxation& relaxation)
      : decay(relaxation.decay), gain(stiffness * relaxation.mean) {}
};

/// Simulates dF/dt = k dz/dt - F/tau with tau = 1/(2 pi f_b), where f_b is the break frequency. The step F+ = e F + k
/// tau (dz/dt)(1 - e), e = exp(-dt/tau), is exact for a displacement that is linear between samples, at any step
/// length. Memory: the force. Source: Polach (IAVSD 2015), Eqs. 13 to 19.
class Maxwell final : public ParallelElement {
 public:
  Maxwell(double stiffness /* k [N/m] */, double break_frequency /* f_b [Hz] */)
      : stiffness_(stiffness), relaxation_time_(1.0 / (2.0 * kPi * break_frequency)), rate_(1.0 / relaxation_time_) {}

  double stiffness() const { return stiffness_; }
  double relaxationTime() const { return relaxation_time_; }  ///< tau [s]
  double rate() const { return rate_; }                       ///< 1/tau [1/s]

  std::size_t memorySize() const override { return 1; }
  double step(const Motion& motion, double* memory) const override {
    const MaxwellStep coefficients(stiffness_, Relaxation::over(motion.dt * rate_));
    return memory[0] = maxwellForce(coefficients.decay, coefficients.gain, memory[0], motion.increment);
  }
  Part part() const override { return Part::viscous; }
  bool addTo(BasicLaws& sum) const override {
    sum.maxwells.push_back({stiffness_, rate_});
    return true;
  }
  std::optional<std::complex<double>> complexStiffness(double omega) const override {
    const std::complex<double> iwt(0.0, omega * relaxation_time_);
    return stiffness_ * iwt / (1.0 + iwt);
  }

 private:
  double stiffness_;
  double relaxation_time_;
  double rate_;
};

}  // namespace rubber_suspension::element
