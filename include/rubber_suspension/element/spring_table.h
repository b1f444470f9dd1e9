// Spring whose characteristic is given by points.
#pragma once

#include <vector>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F(z) through the points (z_i, F_i), linear between them and with the end slopes beyond. No loss.
/// The displacements increase. Where monotone, the forces do not decrease, and F(0) = 0: a preload is a `force_offset`.
/// Else they are any characteristic, such as one in absolute displacements and forces, and the spring may be active.
/// Validity: quasi-static characteristic; beyond the ends the table extrapolates without knowledge.
class SpringTable final : public ParallelElement {
 public:
  /// Throws std::invalid_argument on lists that break the rules above.
  SpringTable(std::vector<double> displacement /* [m] */, std::vector<double> force /* [N] */, bool monotone = true);

  double force(double displacement) const;

  double initialise(double displacement, double* /*memory*/) const override { return force(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return force(motion.displacement); }
  Part part() const override { return Part::elastic; }
  bool passive() const override { return monotone_; }

 private:
  std::vector<double> displacement_;
  std::vector<double> force_;
  bool monotone_;
};

ElementType springTableType();

}  // namespace rubber_suspension::element
