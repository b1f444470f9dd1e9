// Separate forces of several Maxwell elements with the same motion, for fits.
#pragma once

#include <cstddef>
#include <vector>

#include "rubber_suspension/element/basic_laws.h"

namespace rubber_suspension::kernel {

/// Computes the force [N] of each element after each step of dt [s] from `start` [m], where it is 0, to the
/// displacements [m]. The results equal those of the law bit by bit. Several elements take little more time than one,
/// because their steps are interleaved and each step has to wait for the preceding step of its element.
void maxwellForces(const std::vector<element::BasicLaws::MaxwellNumbers>& elements, double dt, double start,
                   const double* displacement, std::size_t count, const std::vector<double*>& force);

}  // namespace rubber_suspension::kernel
