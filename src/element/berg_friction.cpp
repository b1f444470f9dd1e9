// Berg's friction element.
#include "rubber_suspension/element/berg_friction.h"

#include <cmath>

#include "element/registry.h"

namespace rubber_suspension::element {

double BergFriction::initialise(double displacement, double* memory) const {
  memory[kReferenceDisplacement] = displacement;
  memory[kReferenceForce] = 0.0;
  memory[kExtremum] = displacement;
  memory[kDirection] = 0.0;
  return 0.0;
}

double BergFriction::startSettled(double amplitude, double centre, double* memory) const {
  memory[kReferenceDisplacement] = centre - amplitude;
  memory[kReferenceForce] = -settledForce(amplitude);
  memory[kExtremum] = centre - amplitude;
  memory[kDirection] = 1.0;
  return memory[kReferenceForce];
}

std::size_t BergFriction::followUntilReversal(const double* displacement, std::size_t count, double* memory) const {
  std::size_t i = 0;
  for (; i < count && memory[kDirection] == 0.0; ++i) {
    reverse(displacement[i], 0.0, memory);  // starts a branch once the motion leaves the rest position
  }
  const double direction = memory[kDirection];
  double extremum = memory[kExtremum];
  for (; i < count; ++i) {
    const double beyond = (displacement[i] - extremum) * direction;
    if (beyond > 0.0) {
      extremum = displacement[i];
    } else if (-beyond > dead_band_) {
      break;
    }
  }
  memory[kExtremum] = extremum;
  return i;
}

double BergFriction::solveSeriesBalance(double slope, double offset, double compliance, const double* memory) const {
  const double reference = memory[kReferenceDisplacement];
  const double at_reference = slope * reference + offset + compliance * memory[kReferenceForce];
  const double direction = at_reference < 0.0 ? 1.0 : -1.0;  // the sum rises with z
  const double left = maximum_force_ - direction * memory[kReferenceForce];
  const double reach = compliance_ * left;
  // The travel w >= 0 is the root of slope w^2 + linear w - constant = 0, computed here without cancellation.
  const double constant = std::abs(at_reference) * reach;
  const double linear = slope * reach + compliance * left - std::abs(at_reference);
  const double root = std::sqrt(linear * linear + 4.0 * slope * constant);
  const double travel = linear > 0.0 ? 2.0 * constant / (linear + root) : (root - linear) / (2.0 * slope);
  return reference + direction * travel;
}

double BergFriction::settledForce(double amplitude) const {
  const double z2 = displacement_;
  const double z0 = amplitude;
  return maximum_force_ / (2.0 * z2) * (std::sqrt(z2 * z2 + z0 * z0 + 6.0 * z2 * z0) - z2 - z0);
}

double BergFriction::settledLoss(double amplitude) const {
  const double reach = displacement_ * (1.0 + settledForce(amplitude) / maximum_force_);
  const double mu_factor = 1.0 + settledForce(amplitude) / maximum_force_;
  const double travel = 2.0 * amplitude;
  return 2.0 * maximum_force_ * (travel - displacement_ * mu_factor * mu_factor * std::log1p(travel / reach));
}

namespace {

const ElementEntry kBergFrictionEntry(
    230, {"friction",
          "Berg's friction element: smooth, rate-independent, amplitude-dependent stiffness and loss.",
          {{"maximum_force", "N", Role::scale, Range::positive(), "force F_max that the friction approaches"},
           {"displacement", "m", Role::shape, Range::positive(),
            "displacement z2 from rest at which friction reaches half of its maximum"},
           {"dead_band", "m", Role::choice, Range::nonNegative(),
            "smallest travel back from an extremum that counts as a reversal; choose about 6 standard deviations of "
            "the sensor noise",
            0.0}},
          makes<BergFriction>("maximum_force", "displacement", "dead_band")});

}  // namespace
}  // namespace rubber_suspension::element
