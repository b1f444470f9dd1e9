// What vector instructions make of a log, written by hand for five Maxwell elements and Berg friction alone, with
// products and sums fused.
#pragma once

#include <vector>

#include "benchmark/bare_loop.h"

namespace rubber_suspension::benchmark {

/// Five Maxwell elements.
constexpr std::size_t kBareElements = 5;

/// Force [N] at every sample as bareLoop() has it, by the state-space form: a few samples at once from the state before
/// them.
void bareBlockLoop(const BareParameters& parameters, double dt, const std::vector<double>& displacement,
                   std::vector<double>& force);

}  // namespace rubber_suspension::benchmark
