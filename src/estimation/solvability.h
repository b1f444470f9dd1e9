// Intervals of a single input in which a specification has a solution, for errors about specifications without one.
#pragma once

#include <functional>
#include <string>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// Returns true if a specification has a solution.
using Solvable = std::function<bool(const Specification&)>;

/// Resolution of the scan: fine if a decision is fast, coarse if it needs a settled loop.
enum class Scan { fine, coarse };

/// Returns the open intervals of one input, in ascending order, in which a solution exists while the others are kept.
/// The search extends from 1e-4 to 1e4 times the given value (coarse: 1e-2 to 1e2), and is dense near the other inputs
/// of the same unit; an interval that reaches the end of the search is extended to the end of the parameter's range.
std::vector<element::Range> solvableIntervals(const Specification& specification, const element::ParameterInfo& input,
                                              const Solvable& solvable, Scan scan = Scan::fine);

/// Returns "dynamic_stiffness in (3e+06, 4e+06) N/m; ... (each with the others unchanged); nearest: specification:
/// {...}" over all inputs that help, or that none does. The nearest is a line of a component file with the one input
/// changed that needs the smallest ratio; if none helps and the scan is fine, two.
std::string describeSolvableInputs(const Specification& specification, const Solvable& solvable,
                                   Scan scan = Scan::fine);

}  // namespace rubber_suspension::estimation
