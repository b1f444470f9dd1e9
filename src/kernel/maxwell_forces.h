// Separate forces of Maxwell elements with the same motion, for fits.
#pragma once

#include <cstddef>
#include <vector>

#include "rubber_suspension/element/basic_laws.h"

namespace rubber_suspension::kernel {

/// Computes the force [N] of each element, which is 0 at the displacement `start`, after each step of dt [s] to the
/// displacements [m], to the same bits as the law. A step waits for the one before it, so several interleaved elements
/// need little more time than one.
void maxwellForces(const std::vector<element::BasicLaws::MaxwellNumbers>& elements, double dt, double start,
                   const double* displacement, std::size_t count, const std::vector<double*>& force);

}  // namespace rubber_suspension::kernel
