// The bare lane loops: their numbers, and the choice of instructions.
#include "benchmark/bare_lanes.h"

#include <cmath>
#include <stdexcept>

#include "benchmark/bare_numbers.h"
#define RUBBER_SUSPENSION_LAYER benchmark
#define RUBBER_SUSPENSION_KERNELS "benchmark/bare_kernels.h"
#include "kernel/instruction_sets.h"
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

BareLanes::BareLanes(const std::vector<BareParameters>& parameters, double dt) {
  if (parameters.size() % 8 != 0) {
    throw std::invalid_argument("the bare lane loop is there for multiples of eight components");
  }
  rows_.resize(parameters.size() / 8 * kBareRows);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const BareParameters& given = parameters[i];
    const auto number = [&](std::size_t slot) -> double& { return rows_[i / 8 * kBareRows + slot].lane[i % 8]; };
    number(kBareSpring) = given.spring;
    number(kBareMaximumForce) = given.maximum_force;
    number(kBareCompliance) = given.friction_displacement / given.maximum_force;
    for (std::size_t k = 0; k < kBareElements; ++k) {
      const StepOfElement step = stepOf(given, k, dt);
      number(kBareDecay + k) = step.decay;
      number(kBareGain + k) = step.gain;
    }
  }
  rest(0.0);
}

void BareLanes::rest(double displacement) {
  for (std::size_t first = 0; first < rows_.size(); first += kBareRows) {
    const auto fill = [&](std::size_t slot, double value) {
      for (double& number : rows_[first + slot].lane) {
        number = value;
      }
    };
    fill(kBareDisplacement, displacement);
    fill(kBareReferenceDisplacement, displacement);
    fill(kBareReferenceForce, 0.0);
    fill(kBareDirection, 1.0);
    for (std::size_t k = 0; k < kBareElements; ++k) {
      fill(kBareForce + k, 0.0);
    }
  }
}

void BareLanes::tick(const double* displacement, double* force) {
  RUBBER_SUSPENSION_KERNEL(tickAll)(rows_.data(), rows_.size() / kBareRows * 8, displacement, force);
}

void BareLanes::sumSquares(const std::vector<double>& displacement, double* sum) {
  RUBBER_SUSPENSION_KERNEL(sumSquaresOfAll)
  (rows_.data(), rows_.size() / kBareRows * 8, displacement.data(), displacement.size(), sum);
}

}  // namespace rubber_suspension::benchmark
