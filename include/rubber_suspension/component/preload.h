// Preloads of a component of six directions, and tables by which a preload scales forces. No function here throws.
#pragma once

#include <vector>

#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::component {

/// Static load of a direction, which defines the working point of its specification and of its tables.
struct Preload {
  bool is_force = true;  ///< true for a force, false for a displacement
  double value = 0.0;    ///< [N, N m], or [m, rad]
};

/// A table by which the preload of one direction scales the forces of another. It is evaluated once, at the configured
/// preload, because a factor that followed the motion would make forces do work over closed loops.
struct PreloadTable {
  Direction direction = kX;      ///< direction whose forces are scaled
  Direction by = kZ;             ///< direction whose preload determines the factor
  std::vector<Preload> preload;  ///< points of the table, increasing
  std::vector<double> factor;    ///< factor at each point; linear between points, constant beyond them

  /// Returns the factor for a preload [N, N m, m, rad] of the same kind as the points.
  double factorAt(double value) const;
};

/// Multiplies all forces of elements by a factor, by means of the parameters in which the forces are linear.
void scaleForces(std::vector<element::ElementDescription>& elements, double factor);

}  // namespace rubber_suspension::component
