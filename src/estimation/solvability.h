// Intervals of a single input in which a specification has a solution, for messages about specifications without one.
#pragma once

#include <functional>
#include <string>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// Returns true if a specification has a solution.
using Solvable = std::function<bool(const Specification&)>;

/// Resolution of the scan: fine if a check is fast, coarse if a check has to simulate a settled loop.
enum class Scan { fine, coarse };

/// Returns the open intervals of one input, ascending, in which a solution exists with the other inputs unchanged. The
/// search extends from 1e-4 to 1e4 times the given value (coarse: 1e-2 to 1e2), and is dense near other inputs of the
/// same unit. An interval at a limit of the search is extended to the parameter's range.
std::vector<element::Range> solvableIntervals(const Specification& specification, const element::ParameterInfo& input,
                                              const Solvable& solvable, Scan scan = Scan::fine);

/// Returns "dynamic_stiffness in (3e+06, 4e+06) N/m; ... (each with the others unchanged); nearest: specification:
/// {...}" for all inputs that help, or states that none does. The nearest specification changes one input by the
/// smallest ratio, or two inputs if none helps alone and the scan is fine.
std::string describeSolvableInputs(const Specification& specification, const Solvable& solvable,
                                   Scan scan = Scan::fine);

}  // namespace rubber_suspension::estimation
