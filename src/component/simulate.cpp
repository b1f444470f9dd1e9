// Many steps of equal length at once: the sums of Component::step, law after law over a block of samples, so that what
// the laws remember stays in registers. The same bits as step by step.
#include <algorithm>
#include <array>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension {
namespace {

constexpr std::size_t kBlock = 256;  // samples; four arrays of as many numbers fit the first-level cache

// Forces of `width` Maxwell elements over a block, added to the sums in the order of the elements. The recursions of
// the elements wait for themselves alone, so several side by side take as long as one.
template <std::size_t width>
void addMaxwells(const double* decay, const double* gain, const double* increment, std::size_t count, double* memory,
                 double* sum) {
  std::array<double, width> force{};
  for (std::size_t i = 0; i < width; ++i) {
    force[i] = memory[i];
  }
  for (std::size_t sample = 0; sample < count; ++sample) {
    double total = sum[sample];
    for (std::size_t i = 0; i < width; ++i) {
      force[i] = decay[i] * force[i] + gain[i] * increment[sample];
      total += force[i];
    }
    sum[sample] = total;
  }
  for (std::size_t i = 0; i < width; ++i) {
    memory[i] = force[i];
  }
}

using AddMaxwells = void (*)(const double*, const double*, const double*, std::size_t, double*, double*);

// By the number of elements.
constexpr std::array<AddMaxwells, 7> kAddMaxwells = {nullptr,        addMaxwells<1>, addMaxwells<2>, addMaxwells<3>,
                                                     addMaxwells<4>, addMaxwells<5>, addMaxwells<6>};
constexpr std::size_t kMostMaxwells = kAddMaxwells.size() - 1;  // more need more registers than there are

}  // namespace

void Component::simulate(ComponentState& state, double dt, const double* displacement, std::size_t count,
                         double* force) const {
  if (dt != state.prepared_dt_) {
    prepare(state, dt);
  }
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::size_t size = std::min(kBlock, count - first);
    if (plain_) {
      simulateBlock(state, displacement + first, size, force + first);
    } else {
      std::transform(displacement + first, displacement + first + size, force + first,
                     [&](double z) { return stepThroughEffects(state, dt, z).total; });
    }
  }
}

void Component::simulateBlock(ComponentState& state, const double* displacement, std::size_t count,
                              double* force) const {
  std::array<double, kBlock> increment{};
  std::array<double, kBlock> viscous{};
  std::array<double, kBlock> friction{};
  increment[0] = displacement[0] - state.displacement_;
  for (std::size_t i = 1; i < count; ++i) {
    increment[i] = displacement[i] - displacement[i - 1];
  }
  for (std::size_t i = 0; i < count; ++i) {
    viscous[i] = state.dashpot_gain_ * increment[i];
  }
  state.displacement_ = displacement[count - 1];

  double* memory = state.memory_.data();
  const std::size_t maxwells = maxwell_stiffness_.size();
  for (std::size_t first = 0; first < maxwells; first += kMostMaxwells) {
    kAddMaxwells[std::min(kMostMaxwells, maxwells - first)](state.maxwell_decay_.data() + first,
                                                            state.maxwell_gain_.data() + first, increment.data(), count,
                                                            memory + first, viscous.data());
  }
  double* berg_memory = memory + maxwells;
  for (const BergFriction& berg : bergs_) {
    berg.addForces(displacement, count, berg_memory, friction.data());
    berg_memory += BergFriction::kMemorySize;
  }
  for (std::size_t i = 0; i < count; ++i) {
    force[i] = spring_stiffness_ * displacement[i] + viscous[i] + friction[i];
  }
}

}  // namespace rubber_suspension
