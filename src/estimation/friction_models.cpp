// M4 (Berg friction), M5 (with dashpot) and M6 (with Maxwell element) from stiffness and loss at the working point.
// Sources: Polach (IAVSD 2015); M. Berg, Proc. IMechE F 211 (1997) 95-108. Symbols are those of specification.h.
#include <fmt/format.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>

#include "estimation/models.h"
#include "estimation/root.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::estimation {
namespace {

// Returns mu0 = F_f0/F_max of the settled Berg loop of amplitude z0. It depends only on u = 2 z0/(z2 (1 + mu0)): the
// branch from -F_f0 ends at F_f0, so mu0 = u/(2 + u). u -> 0 is a spring, u -> infinity is Coulomb friction.
double settledMu(double u) { return u / (2.0 + u); }

// Returns the loss of the settled loop over F_f0 z0: 4 ((2 + u) u - 2 (1 + u) ln(1 + u))/u^2, from 0 to 4 (Coulomb).
double lossRatio(double u) {
  if (u > 0.1) {
    return 4.0 * ((2.0 + u) * u - 2.0 * (1.0 + u) * std::log1p(u)) / (u * u);
  }
  // At small u the difference loses digits, so its series is used: 8 sum over n >= 3 of (-1)^(n+1) u^(n-2)/(n (n-1)).
  double sum = 0.0;
  double power = u;
  for (int n = 3; n < 20; ++n) {
    sum += power / (n * (n - 1));
    power *= -u;
  }
  return 8.0 * sum;
}

constexpr double kCoulombLossRatio = 4.0;
// Margin of the root from u = infinity, Coulomb friction.
constexpr double kStiffnessMargin = 1e-12;

// Returns the Berg element whose settled loop of this amplitude has this u and this peak force.
element::ElementDescription bergElement(double u, double peak_force, double amplitude) {
  const double mu = settledMu(u);
  return {"friction", {{"maximum_force", {peak_force / mu}}, {"displacement", {2.0 * amplitude / (u * (1.0 + mu))}}}};
}

// Stiffness and loss at the working point.
struct WorkingPoint {
  double k_st;            // [N/m]
  double k_n;             // [N/m]
  double loss_stiffness;  // K_n sin(delta): loss per cycle over pi A^2 [N/m]
  double viscous_share;   // share of the loss that is viscous [-]
  double amplitude;       // [m]

  double viscousLossStiffness() const { return viscous_share * loss_stiffness; }
  // Returns the friction's loss per cycle over A^2 [N/m].
  double frictionLoss() const { return element::kPi * (1.0 - viscous_share) * loss_stiffness; }
};

WorkingPoint workingPoint(const Specification& specification, double viscous_share) {
  const double k_n = specification.at("dynamic_stiffness");
  return {specification.at("static_stiffness"), k_n, k_n * std::sin(lossAngle(specification)), viscous_share,
          specification.at("nominal_amplitude")};
}

double viscousShare(const Specification& specification) { return valueOrDefault(specification, "viscous_share"); }

// Returns the obstacle that the stiffness is too low for this loss even with Coulomb friction, the least stiff one.
Obstacle tooLossy(double k_lowest) {
  return {"dynamic_stiffness",
          fmt::format("is less than {:.6g} N/m, the least stiffness of friction with this loss per cycle", k_lowest)};
}

// Checks M4 and M5. A dashpot has no force at the turning points, which define the stiffness: K_n = K_st + F_f0/A_n.
std::optional<Obstacle> turningPointObstacle(const WorkingPoint& point) {
  const double k_lowest = point.k_st + point.frictionLoss() / kCoulombLossRatio;
  return point.k_n > k_lowest * (1.0 + kStiffnessMargin) ? std::nullopt : std::optional<Obstacle>(tooLossy(k_lowest));
}

element::ElementDescription frictionAtTurningPoint(const WorkingPoint& point) {
  const double friction_stiffness = point.k_n - point.k_st;
  const double ratio = point.frictionLoss() / friction_stiffness;
  const double u = increasingRoot([&](double trial) { return lossRatio(trial) - ratio; });
  return bergElement(u, friction_stiffness * point.amplitude, point.amplitude);
}

// Returns K* of spring and Maxwell element of M6 at f_n. The Maxwell element has the viscous share of the loss.
std::complex<double> linearStiffness(const WorkingPoint& point, double frequency_ratio /* f_n/f_b */) {
  const double loss = point.viscousLossStiffness();
  return {point.k_st + loss * frequency_ratio, loss};
}

// Returns the peak force over the amplitude of the settled loop (Eq. 1). The viscous part shifts the peak to a little
// before the turning point. The search varies `phase`, the angle before the turning point.
double peakStiffness(std::complex<double> linear, double u, double friction_stiffness /* F_f0/A */) {
  const double mu = settledMu(u);
  const auto minus_force = [&](double phase) {
    const double way = u * 0.5 * (1.0 + std::cos(phase));  // displacement from the reference point, over z2 (1 + mu0)
    const double friction = friction_stiffness * (-1.0 + (1.0 / mu + 1.0) * way / (1.0 + way));
    return -(linear.real() * std::cos(phase) + linear.imag() * std::sin(phase) + friction);
  };
  return -boost::math::tools::brent_find_minima(minus_force, 0.0, 0.5 * element::kPi, 40).second;
}

}  // namespace

std::optional<Obstacle> frictionObstacle(const Specification& specification) {
  return turningPointObstacle(workingPoint(specification, 0.0));
}

std::optional<Obstacle> frictionDashpotObstacle(const Specification& specification) {
  return turningPointObstacle(workingPoint(specification, viscousShare(specification)));
}

std::optional<Obstacle> bergObstacle(const Specification& specification) {
  const WorkingPoint point = workingPoint(specification, viscousShare(specification));
  const double ratio = specification.at("nominal_frequency") / specification.at("break_frequency");
  const double k_lowest = std::abs(linearStiffness(point, ratio)) + point.frictionLoss() / kCoulombLossRatio;
  return point.k_n > k_lowest * (1.0 + kStiffnessMargin) ? std::nullopt : std::optional<Obstacle>(tooLossy(k_lowest));
}

std::vector<element::ElementDescription> estimateFriction(const Specification& specification) {
  const WorkingPoint point = workingPoint(specification, 0.0);
  return {{"spring", {{"stiffness", {point.k_st}}}}, frictionAtTurningPoint(point)};
}

std::vector<element::ElementDescription> estimateFrictionDashpot(const Specification& specification) {
  const WorkingPoint point = workingPoint(specification, viscousShare(specification));
  const double damping = point.viscousLossStiffness() / (2.0 * element::kPi * specification.at("nominal_frequency"));
  return {
      {"spring", {{"stiffness", {point.k_st}}}}, frictionAtTurningPoint(point), {"dashpot", {{"damping", {damping}}}}};
}

std::vector<element::ElementDescription> estimateBerg(const Specification& specification) {
  const WorkingPoint point = workingPoint(specification, viscousShare(specification));
  const double break_frequency = specification.at("break_frequency");
  const double ratio = specification.at("nominal_frequency") / break_frequency;
  const std::complex<double> linear = linearStiffness(point, ratio);
  const auto frictionStiffness = [&](double u) { return point.frictionLoss() / lossRatio(u); };
  const double u =
      increasingRoot([&](double trial) { return point.k_n - peakStiffness(linear, trial, frictionStiffness(trial)); });
  std::vector<element::ElementDescription> elements = {
      {"spring", {{"stiffness", {point.k_st}}}},
      bergElement(u, frictionStiffness(u) * point.amplitude, point.amplitude)};
  if (point.viscous_share > 0.0) {
    const double stiffness = point.viscousLossStiffness() * (ratio + 1.0 / ratio);
    elements.push_back({"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {break_frequency}}}});
  }
  return elements;
}

}  // namespace rubber_suspension::estimation
