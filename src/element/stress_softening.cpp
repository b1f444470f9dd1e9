// Stress softening (Mullins effect): a test piece is softer within displacements that it has reached before.
#include <algorithm>
#include <cmath>

#include "element/registry.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

enum SofteningSlot { kLargest, kReach };

double powerOf(double base, double exponent) {
  if (exponent == 1.0) {
    return base;
  }
  return exponent == 2.0 ? base * base : std::pow(base, exponent);
}

// Returns tanh with a small absolute error, which suffices for a factor and costs less than a small relative error.
double tanhOf(double value) { return 1.0 - 2.0 / (1.0 + std::exp(2.0 * value)); }

/// Multiplies the force of the test piece by 1 - R(S) tanh(u/w)/tanh(1/w), u = 1 - |z/S|^a for |z| < S, or by 1 for |z|
/// >= S.
///
/// S is the softened reach, at most the largest past displacement M. With path length L = 0, S equals M, so the factor
/// is 1 on the first loading and beyond M. With L > 0, S approaches M with the
/// distance travelled, dS = (M - S)(1 - exp(-|dz|/L)), so that softening takes about L/(4 A) cycles of amplitude A.
/// While S is constant, the factor depends on z only, so the effect adds loss only while S grows.
///
/// The reduction grows with the reach, R(S) = R min(S/S_f, 1)^q; for q = 0 it is R at any reach. With a side, only
/// displacements to that side determine M, and only the force on that side is softened. The reduction rises linearly
/// from 0 at S/4 on the other side of zero to its full value at S/4 on that side, so that the force has no jump. With a
/// recovery time T, M and S return to the present displacement, dM/dt = -(M - |z|)/T. Without T softening is permanent,
/// as it is in rubber over the hours of a test. Validity: the displacement must determine the strain energy, as for one
/// shape of the test piece and one kind of load. Memory: M, S. Source: pseudo-elasticity of R. W. Ogden and D. G.
/// Roxburgh, Proc. R. Soc. A 455 (1999) 2861-2877, here with a tanh instead of their error function. For a = 2, u is
/// the share by which the energy of a linear spring is below its maximum; a = 1 uses displacement as M. F. Beatty and
/// S. Krishnaswamy, J. Mech. Phys. Solids 48 (2000) 1931-1965, use strain. Reduction that grows with the largest
/// strain, and recovery: J. Diani, B. Fayolle, P. Gilormini, Eur. Polymer J. 45 (2009) 601-612.
class StressSoftening final : public ForceEffect {
 public:
  enum class Side { lower = -1, both = 0, upper = 1 };

  struct Parameters {
    double reduction;       ///< R [-]
    double width;           ///< w [-]
    double path;            ///< L [m]; 0: softening is immediate
    double reach_exponent;  ///< q [-]
    double full_reach;      ///< S_f [m]; must be greater than 0 if q > 0
    double recovery_time;   ///< T [s]; 0: softening is permanent
    Side side;
    double ratio_power;  ///< a [-]
  };

  explicit StressSoftening(const Parameters& parameters)
      : parameters_(parameters), deepest_(std::tanh(1.0 / parameters.width)) {}

  std::size_t memorySize() const override { return 2; }
  void initialise(double displacement, double* memory) const override {
    memory[kLargest] = memory[kReach] = reachOf(displacement);
  }

  // A long rest undoes all softening if there is a recovery time. Otherwise it can only extend the reaches.
  double relax(double displacement, double* memory) const override {
    if (parameters_.recovery_time > 0.0) {
      initialise(displacement, memory);
      return 1.0;
    }
    memory[kLargest] = std::max(memory[kLargest], reachOf(displacement));
    if (parameters_.path == 0.0) {
      memory[kReach] = memory[kLargest];
    }
    return factor(displacement, memory[kReach]);
  }

  double step(const Motion& motion, const ComponentForce& /*force*/, double* memory) const override {
    const double reached = reachOf(motion.displacement);
    if (parameters_.recovery_time > 0.0) {
      recover(motion.dt, reached, memory);
    }
    memory[kLargest] = std::max(memory[kLargest], reached);
    if (parameters_.path == 0.0) {
      memory[kReach] = memory[kLargest];
    } else if (memory[kReach] < memory[kLargest]) {
      const double kept = Relaxation::over(std::abs(motion.increment) / parameters_.path).decay;
      memory[kReach] += (memory[kLargest] - memory[kReach]) * (1.0 - kept);
    }
    return factor(motion.displacement, memory[kReach]);
  }

  double factor(double displacement, double reach) const {
    if (std::abs(displacement) >= reach) {
      return 1.0;
    }
    const double ratio = std::abs(displacement) / reach;
    const double lacking = (1.0 - powerOf(ratio, parameters_.ratio_power)) / parameters_.width;
    return 1.0 - reductionAt(reach) * shareOfSide(displacement, reach) * tanhOf(lacking) / deepest_;
  }

 private:
  /// Returns the distance [m] of a displacement from 0 on the active side, which is 0 on the other side.
  double reachOf(double displacement) const {
    return parameters_.side == Side::both ? std::abs(displacement)
                                          : std::max(0.0, static_cast<double>(parameters_.side) * displacement);
  }

  /// Returns the share of the reduction at a displacement: 0 on the other side, 1 on the active side [-].
  double shareOfSide(double displacement, double reach) const {
    constexpr double kBlended = 0.25;  // share of the reach, to either side of zero
    if (parameters_.side == Side::both) {
      return 1.0;
    }
    const double beyond = static_cast<double>(parameters_.side) * displacement / (kBlended * reach);
    return std::clamp(0.5 * (1.0 + beyond), 0.0, 1.0);
  }

  double reductionAt(double reach) const {
    const double exponent = parameters_.reach_exponent;
    return exponent == 0.0 ? parameters_.reduction
                           : parameters_.reduction * powerOf(std::min(reach / parameters_.full_reach, 1.0), exponent);
  }

  // Lets M and S decay towards `reached` [m], the distance of the present displacement from 0 on the active side.
  void recover(double dt, double reached, double* memory) const {
    const double kept = Relaxation::over(dt / parameters_.recovery_time).decay;
    for (const SofteningSlot slot : {kLargest, kReach}) {
      memory[slot] = std::min(memory[slot], reached + std::max(0.0, memory[slot] - reached) * kept);
    }
  }

  Parameters parameters_;
  double deepest_;  // tanh(1/w)
};

ElementPointer makeStressSoftening(const ElementDescription& description) {
  const StressSoftening::Parameters parameters{description.value("reduction"),
                                               description.value("width"),
                                               description.value("path"),
                                               description.value("reach_exponent"),
                                               description.value("full_reach"),
                                               description.value("recovery_time"),
                                               static_cast<StressSoftening::Side>(sideOf(description, "z")),
                                               description.value("ratio_power")};
  if (parameters.reach_exponent > 0.0 && parameters.full_reach == 0.0) {
    refuseValue(description.type, "full_reach", 0.0, "m", "greater than 0 if a reach_exponent is given");
  }
  return std::make_shared<const StressSoftening>(parameters);
}

const ElementEntry kStressSofteningEntry(
    330,
    {"stress_softening",
     "Mullins effect: the rubber is softer within displacements that it reached before.",
     {{"reduction", "1", Role::shape, Range::closed(0.0, 0.9), "share R of the force lost at small displacements"},
      {"width", "1", Role::shape, Range::closed(0.01, 10.0),
       "width w of the transition, on the scale of 1 - |z/S|^a with the largest past displacement S", 0.5},
      {"path", "m", Role::shape, Range::nonNegative(),
       "travel over which the softening develops; 0: the softening is immediate", 0.0},
      {"reach_exponent", "1", Role::shape, Range::closed(0.0, 4.0),
       "power q: the reduction grows with the power q of the largest past displacement; 0: constant reduction", 0.0},
      {"full_reach", "m", Role::shape, Range::nonNegative(),
       "largest past displacement at which the reduction reaches R; beyond it the reduction is constant", 0.0},
      {"recovery_time", "s", Role::shape, Range::nonNegative(),
       "time in which the component recovers from the softening; 0: the softening is permanent", 0.0},
      {"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: softens at z > 0 only, -1: at z < 0 only, 0: both",
       0.0},
      {"ratio_power", "1", Role::choice, Range::closed(0.5, 8.0),
       "power a of the ratio |z/S| in the transition; 2: transition over the strain energy; 1: over the displacement",
       2.0}},
     makeStressSoftening});

}  // namespace
}  // namespace rubber_suspension::element
