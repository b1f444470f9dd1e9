// Preloads of a component of six directions, and tables by which one scales the forces of another. Throws nothing.
#pragma once

#include <vector>

#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::component {

/// Static load of a direction: the working point of its specification and of tables over a preload.
struct Preload {
  bool is_force = true;  ///< else a displacement
  double value = 0.0;    ///< [N, N m], or [m, rad]
};

/// A table by which the preload of one direction scales the forces of another. It is evaluated once, at the configured
/// preload, because a factor that followed the motion would do work over closed loops.
struct PreloadTable {
  Direction direction = kX;      ///< that is scaled
  Direction by = kZ;             ///< whose preload scales it
  std::vector<Preload> preload;  ///< points, increasing
  std::vector<double> factor;    ///< at the points; linear between, constant beyond

  /// Returns the factor at a preload of the kind of its points [N, N m, m, rad].
  double factorAt(double value) const;
};

/// Multiplies all forces of elements by a factor, through the parameters in which they are linear.
void scaleForces(std::vector<element::ElementDescription>& elements, double factor);

}  // namespace rubber_suspension::component
