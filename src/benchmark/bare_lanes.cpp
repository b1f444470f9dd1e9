// The bare loop over blocks: its numbers, and the choice of instructions.
#include "benchmark/bare_lanes.h"

#include <cmath>
#include <stdexcept>

#include "benchmark/bare_numbers.h"
#define RUBBER_SUSPENSION_LAYER benchmark
#define RUBBER_SUSPENSION_KERNELS "benchmark/bare_kernels.h"
#include "processor/instruction_sets.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::benchmark {
namespace {

struct StepOfElement {
  double decay;
  double gain;
};

StepOfElement stepOf(const BareParameters& parameters, std::size_t element, double dt) {
  const double ratio = 2.0 * element::kPi * parameters.break_frequency.at(element) * dt;
  const double released = -std::expm1(-ratio);
  return {1.0 - released, parameters.stiffness.at(element) * released / ratio};
}

}  // namespace

void bareBlockLoop(const BareParameters& parameters, double dt, const std::vector<double>& displacement,
                   std::vector<double>& force) {
  BareBlock work{parameters.spring,
                 parameters.maximum_force,
                 parameters.friction_displacement,
                 {},
                 {},
                 displacement.data(),
                 displacement.size(),
                 force.data()};
  for (std::size_t k = 0; k < kBareElements; ++k) {
    const StepOfElement step = stepOf(parameters, k, dt);
    work.decay[k] = step.decay;
    work.gain[k] = step.gain;
  }
  if (RUBBER_SUSPENSION_KERNEL(runBlocks)(work) != work.count) {
    throw std::invalid_argument("the bare block loop is there for multiples of eight samples after the first");
  }
}

}  // namespace rubber_suspension::benchmark
