// General solvers of ordinary differential equations on the library's work: five Maxwell elements under the
// displacement of a log, linear between samples. Each gives the sum of their forces [N] at each sample.
#pragma once

#include <vector>

#include "benchmark/bare_loop.h"

namespace rubber_suspension::benchmark {

/// The displacement [m] comes at each kStep.
using PeerSolver = void (*)(const BareMaxwells<5>& maxwells, const std::vector<double>& displacement,
                            std::vector<double>& force);

/// Simbody, Runge-Kutta-Merson with control of the step; the dashpots are auxiliary states of a force.
void simbodyMerson(const BareMaxwells<5>& maxwells, const std::vector<double>& displacement,
                   std::vector<double>& force);

}  // namespace rubber_suspension::benchmark
