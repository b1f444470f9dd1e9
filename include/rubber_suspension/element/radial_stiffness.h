// Spring of two directions across an axis, whose stiffness grows with the distance from the axis.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Simulates F = x (h(r) - (1 - a) h(|x|)), h(r) = k2 r + k3 r^2 + k5 r^4, r = sqrt(x^2 + y^2), which is added to the
/// linear laws of a direction x and depends on another direction y. No loss. If both directions have the same law, the
/// force does no work over closed loops, since it has the potential U = W(r) - (1 - a)(W(|x|) + W(|y|)) >= 0, W' = r h.
/// With a = 1 the force is along the radius. With a = 0 the force vanishes for motion along x or y alone: it is then
/// the difference between a bush that stiffens along the radius and separate laws of x and y. A component of one
/// direction has y = 0. Validity: the radii for which the coefficients were fitted.
/// Source: a radial law F = G(r) (x, y)/r, as in the cylindrical coupling of multibody programs, with G as a power
/// series as in progressive_stiffness. The make() of its type throws std::invalid_argument.
class RadialStiffness final : public ParallelElement {
 public:
  RadialStiffness(double quadratic /* k2 [N/m^2] */, double cubic /* k3 [N/m^3] */, double quintic /* k5 [N/m^5] */,
                  double alone /* a [-] */)
      : quadratic_(quadratic), cubic_(cubic), quintic_(quintic), alone_(alone) {}

  /// alongRadius() returns r h(r) [N] at a radius [m], energy() its potential W [J].
  double alongRadius(double r) const { return r * secant(r); }
  double energy(double r) const { return r * r * r * (quadratic_ / 3.0 + r * (cubic_ / 4.0 + r * r * quintic_ / 6.0)); }

  /// Returns the subtracted term x (1 - a) h(|x|) [N], which depends only on the displacement of this direction [m].
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

/// Returns those of the elements that are radial stiffnesses. Throws std::invalid_argument as their make() does.
std::vector<RadialStiffness> radialLaws(const std::vector<ElementDescription>& elements);

/// Adds to the force [N] of a component with these laws the change that displacements `across` [m] cause.
void addAcross(const std::vector<RadialStiffness>& laws, const double* displacement, const double* across,
               std::size_t count, double* force);

bool isRadial(const ElementDescription& element);

}  // namespace rubber_suspension::element
