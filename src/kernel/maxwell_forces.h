// Forces of Maxwell elements one by one, which a fit needs of the same motion.
#pragma once

#include <cstddef>
#include <vector>

#include "rubber_suspension/element/basic_laws.h"

namespace rubber_suspension::kernel {

/// Of each element the force [N] at the end of as many steps of dt [s] as there are displacements [m], from the
/// displacement `start` on, where it has none; to `force` of each. The bits of the law. Each step of an element waits
/// for the one before it, so several elements side by side take little longer than one.
void maxwellForces(const std::vector<element::BasicLaws::MaxwellNumbers>& elements, double dt, double start,
                   const double* displacement, std::size_t count, const std::vector<double*>& force);

}  // namespace rubber_suspension::kernel
