// Intervals of a single input with a solution, the others unchanged: the help in an error about a specification without
// one.
#pragma once

#include <functional>
#include <string>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// True if a specification has a solution.
using Solvable = std::function<bool(const Specification&)>;

/// Resolution of the scan: fine if a decision is fast, coarse if it needs a settled loop.
enum class Scan { fine, coarse };

/// The intervals of one input, others kept, in which a solution exists; open intervals in ascending order.
/// The search looks from 1e-4 to 1e4 times the given value (coarse: 1e-2 to 1e2), closely near the other inputs of the
/// same unit; an interval that reaches the end of the search is reported up to the end of the parameter's own range.
std::vector<element::Range> solvableIntervals(const Specification& specification, const element::ParameterInfo& input,
                                              const Solvable& solvable, Scan scan = Scan::fine);

/// "dynamic_stiffness in (3e+06, 4e+06) N/m; maximum_stiffness greater than ... (each with the others kept); nearest:
/// specification: {...}" over all inputs that help, or that none does. The nearest is ready for a component file: the
/// one input changed that has the least way to go, as a ratio; where none helps and it is quick to decide, two.
std::string describeSolvableInputs(const Specification& specification, const Solvable& solvable,
                                   Scan scan = Scan::fine);

}  // namespace rubber_suspension::estimation
