// Network of chains that break during motion and form again.
#include <algorithm>
#include <cmath>

#include "element/dead_band.h"
#include "element/registry.h"
#include "element/structure_state.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

enum NetworkSlot { kNetworkForce, kIntact, kNetworkPlace };

// Returns (exp(-a dt) - exp(-b dt))/(b - a) without cancellation: the integral of exp(-a t) exp(-b (dt - t)).
double overlap(double a, double b, double dt) {
  return std::exp(-std::min(a, b) * dt) * dt * Relaxation::over(std::abs(a - b) * dt).mean;
}

/// Simulates dF/dt = k m dz/dt - (1/tau + |dz/dt|/s) F, dm/dt = (1 - m)/T - m |dz/dt|/s, tau = 1/(2 pi f_b), where m is
/// the share of the chains that is intact. Motion breaks chains, which lose their force, and new chains form without
/// force. In steady motion of mean speed v, m = 1/(1 + v T/s), so the settled law is friction whose limit k m s falls
/// with the speed. m depends on the displacement only, so the force is linear in k.
///
/// With a dead band, the speed that breaks chains is the speed behind play of this width, so that noise within the play
/// breaks no chains. The step is exact for a displacement that is linear over it. The law is passive: with the energy W
/// = F^2/(2 k m) the power lost is (1/tau + |dz/dt|/(2 s)) F^2/(k m) + (1 - m) F^2/(2 k m^2 T) >= 0. Memory: the force,
/// m, the displacement behind the play [m]. Source: M. S. Green, A. V. Tobolsky, J. Chem. Phys. 14 (1946) 80-92.
class TransientNetwork final : public ParallelElement {
 public:
  struct Parameters {
    double stiffness;        ///< k [N/m]
    double break_frequency;  ///< f_b [Hz]
    double recovery_time;    ///< T [s]
    double travel;           ///< s [m]
    double dead_band;        ///< width of the play [m]
  };

  explicit TransientNetwork(const Parameters& parameters)
      : parameters_(parameters), rate_at_rest_(2.0 * kPi * parameters.break_frequency) {}

  std::size_t memorySize() const override { return 3; }
  bool acceptsMemory(const double* memory) const override { return memory[kIntact] >= 0.0 && memory[kIntact] <= 1.0; }
  double initialise(double displacement, double* memory) const override {
    memory[kNetworkForce] = 0.0;
    memory[kIntact] = 1.0;
    memory[kNetworkPlace] = displacement;
    return 0.0;
  }

  double step(const Motion& motion, double* memory) const override {
    const Motion way{motion.dt, motion.displacement,
                     advance(motion.displacement, parameters_.dead_band, memory[kNetworkPlace])};
    const StructureState intact(way, parameters_.recovery_time, parameters_.travel);
    const double velocity = motion.increment / motion.dt;
    const double rate = rate_at_rest_ + std::abs(way.increment) / (motion.dt * parameters_.travel);
    const Relaxation relaxation = Relaxation::over(motion.dt * rate);
    const double built = intact.settled * motion.increment * relaxation.mean +
                         (memory[kIntact] - intact.settled) * velocity * overlap(intact.rate, rate, motion.dt);
    memory[kNetworkForce] = relaxation.decay * memory[kNetworkForce] + parameters_.stiffness * built;
    memory[kIntact] = intact.after(memory[kIntact]);
    return memory[kNetworkForce];
  }
  Part part() const override { return Part::viscous; }

 private:
  Parameters parameters_;
  double rate_at_rest_;  // 1/tau [1/s]
};

const ElementEntry kTransientNetworkEntry(
    145, {"transient_network",
          "Network whose intact share m falls during motion and recovers at rest, dm/dt = (1 - m)/T - m |dz/dt|/s: a "
          "friction whose limit falls with the mean speed (Payne effect).",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the intact network"},
           {"break_frequency", "Hz", Role::shape, Range::nonNegative(), "break frequency f_b of the network at rest"},
           {"recovery_time", "s", Role::shape, Range::positive(), "time T over which the network recovers"},
           {"travel", "m", Role::shape, Range::positive(), "travel s that reduces m by a factor of e"},
           {"dead_band", "m", Role::choice, Range::nonNegative(), kDeadBand, 0.0}},
          makes<TransientNetwork, TransientNetwork::Parameters>("stiffness", "break_frequency", "recovery_time",
                                                                "travel", "dead_band")});

}  // namespace
}  // namespace rubber_suspension::element
