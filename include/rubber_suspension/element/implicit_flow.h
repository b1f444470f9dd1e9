// One implicit step of a flow that a power of the force drives. Throws nothing.
#pragma once

namespace rubber_suspension::element {

/// The root x >= 0 of x + b x^m = r for b >= 0, m > 0 and r >= 0: what is left of a force r after a step over which its
/// flow is b x^m. In closed form for m = 1/2, 1 and 2, by Newton's method else, which converges monotonically since the
/// function is convex (in x^m where m < 1). To rounding.
double flowRoot(double r, double b, double m);

}  // namespace rubber_suspension::element
