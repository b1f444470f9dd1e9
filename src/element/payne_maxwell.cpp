// Maxwell element whose relaxation rate grows with the recent speed.
#include <cmath>

#include "element/dead_band.h"
#include "element/registry.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

enum PayneSlot { kPayneForce, kMeanSpeed, kPaynePlace };

/// Simulates dF/dt = k dz/dt - (1/tau + q/s) F, T dq/dt = |dz/dt| - q, tau = 1/(2 pi f_b). q is the speed averaged over
/// the last T. Motion makes the element relax faster, so the stiffness falls during motion and recovers at rest within
/// T (Payne effect). As s tends to infinity, the law becomes a Maxwell element; for T = 0 and f_b = 0 it is Dahl
/// friction with the limit k s. Under a sine of amplitude a whose period is short compared to T, the storage stiffness
/// is k/(1 + (a/a_c)^2) with a_c = pi s/2 at any frequency at which q/s far exceeds 1/tau: Kraus's curve. q depends on
/// the displacement only, so the force is linear in k.
///
/// With a dead band, the speed in the equation of q is the speed behind play of this width, so that noise within the
/// play relaxes nothing. A step uses the mean relaxation rate over the step and is of second order in dt. The law is
/// passive, since the power lost is (1/tau + q/s) F^2/k >= 0. Memory: the force, q, the displacement behind the play
/// [m]. Source: A. Lion, Rubber Chem. Technol. 71 (1998) 410-429; P. Haupt, K. Sedlan, Arch. Appl. Mech. 71 (2001)
/// 89-109; P. Hofer, A. Lion, J. Mech. Phys. Solids 57 (2009) 500-520.
class PayneMaxwell final : public ParallelElement {
 public:
  struct Parameters {
    double stiffness;        ///< k [N/m]
    double break_frequency;  ///< f_b [Hz]
    double recovery_time;    ///< T [s]
    double travel;           ///< s [m]
    double dead_band;        ///< width of the play [m]
  };

  explicit PayneMaxwell(const Parameters& parameters)
      : parameters_(parameters), rate_at_rest_(2.0 * kPi * parameters.break_frequency) {}

  std::size_t memorySize() const override { return 3; }
  bool acceptsMemory(const double* memory) const override { return memory[kMeanSpeed] >= 0.0; }

  double initialise(double displacement, double* memory) const override {
    memory[kPayneForce] = memory[kMeanSpeed] = 0.0;
    memory[kPaynePlace] = displacement;
    return 0.0;
  }

  double step(const Motion& motion, double* memory) const override {
    const double speed = std::abs(advance(motion.displacement, parameters_.dead_band, memory[kPaynePlace])) / motion.dt;
    const double time = parameters_.recovery_time;
    const Relaxation averaging = time > 0.0 ? Relaxation::over(motion.dt / time) : Relaxation{0.0, 0.0};
    const double mean_speed = speed + (memory[kMeanSpeed] - speed) * averaging.mean;
    const Relaxation relaxation = Relaxation::over(motion.dt * (rate_at_rest_ + mean_speed / parameters_.travel));
    memory[kPayneForce] =
        relaxation.decay * memory[kPayneForce] + parameters_.stiffness * motion.increment * relaxation.mean;
    memory[kMeanSpeed] = speed + (memory[kMeanSpeed] - speed) * averaging.decay;
    return memory[kPayneForce];
  }
  Part part() const override { return Part::viscous; }

 private:
  Parameters parameters_;
  double rate_at_rest_;  // 1/tau [1/s]
};

const ElementEntry kPayneMaxwellEntry(
    140, {"payne_maxwell",
          "Maxwell element whose relaxation rate 2 pi f_b + q/s grows with the mean speed q over the past time T: "
          "stiffness falls during motion and recovers at rest (Payne effect).",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k at small amplitude"},
           {"break_frequency", "Hz", Role::shape, Range::nonNegative(), "break frequency f_b at rest"},
           {"recovery_time", "s", Role::shape, Range::nonNegative(), "time T over which the speed is averaged"},
           {"travel", "m", Role::shape, Range::positive(), "travel s that relaxes the force by a factor of e"},
           {"dead_band", "m", Role::choice, Range::nonNegative(), kDeadBand, 0.0}},
          makes<PayneMaxwell, PayneMaxwell::Parameters>("stiffness", "break_frequency", "recovery_time", "travel",
                                                        "dead_band")});

}  // namespace
}  // namespace rubber_suspension::element
