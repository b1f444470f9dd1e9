// Stiffening spring of two directions across an axis, by their radius.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = x (h(r) - (1 - a) h(|x|)), h(r) = k2 r + k3 r^2 + k5 r^4, r = sqrt(x^2 + y^2), to be added to the linear laws of
/// a direction x beside another one y. No loss. With the same law in both directions the force has the potential
/// U = W(r) - (1 - a)(W(|x|) + W(|y|)), W' = r h, which is nowhere less than 0, so that it does no work over closed
/// loops. With a = 1 it is stiffening along the radius. With a = 0 it vanishes for motion along x or y alone; it then
/// completes the separate laws of the two directions to those of a bush that stiffens along the radius. A component of
/// one direction has y = 0. Validity: within the radii that the coefficients were fitted to.
/// Source: a radial law F = G(r) (x, y)/r, as the cylindrical coupling of multibody programs, its G by a power series
/// as in progressive_stiffness. The type's make() throws std::invalid_argument.
class RadialStiffness final : public ParallelElement {
 public:
  RadialStiffness(double quadratic /* k2 [N/m^2] */, double cubic /* k3 [N/m^3] */, double quintic /* k5 [N/m^5] */,
                  double alone /* a [-] */)
      : quadratic_(quadratic), cubic_(cubic), quintic_(quintic), alone_(alone) {}

  /// r h(r) [N] at a radius, and its potential W [J].
  double alongRadius(double r) const { return r * secant(r); }
  double energy(double r) const { return r * r * r * (quadratic_ / 3.0 + r * (cubic_ / 4.0 + r * r * quintic_ / 6.0)); }

  /// The term x (1 - a) h(|x|), which the force subtracts and which depends only on this displacement [N].
  double own(double displacement) const { return (1.0 - alone_) * displacement * secant(std::abs(displacement)); }

  double force(double displacement, double across) const {
    return displacement * secant(std::hypot(displacement, across)) - own(displacement);
  }

  double initialise(double displacement, double* /*memory*/) const override { return force(displacement, 0.0); }
  double step(const Motion& motion, double* /*memory*/) const override { return force(motion.displacement, 0.0); }
  Part part() const override { return Part::elastic; }

 private:
  double secant(double r) const { return r * (quadratic_ + r * (cubic_ + r * r * quintic_)); }

  double quadratic_;
  double cubic_;
  double quintic_;
  double alone_;
};

/// Returns the radial stiffnesses among elements. Throws std::invalid_argument as their make() does.
std::vector<RadialStiffness> radialLaws(const std::vector<ElementDescription>& elements);

/// Adds the change that the displacements `across` cause to the force [N] at each sample of a component with `laws`.
void addAcross(const std::vector<RadialStiffness>& laws, const double* displacement, const double* across,
               std::size_t count, double* force);

bool isRadial(const ElementDescription& element);

}  // namespace rubber_suspension::element
