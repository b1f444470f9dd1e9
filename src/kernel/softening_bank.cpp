// Several laws of stress softening, computed together.
#include "kernel/softening_bank.h"

#include <cmath>
#include <utility>

#define RUBBER_SUSPENSION_LAYER kernel
#define RUBBER_SUSPENSION_KERNELS "kernel/softening_kernels.h"
#include "processor/instruction_sets.h"

namespace rubber_suspension::kernel {

bool SofteningBank::takes(const element::ElementDescription& law) {
  if (law.type != "stress_softening") {
    return false;
  }
  const double by_reach = law.value("reach_exponent");
  const double by_ratio = law.value("ratio_power");
  return (by_reach == 0.0 || by_reach == 1.0 || by_reach == 2.0) && (by_ratio == 1.0 || by_ratio == 2.0);
}

void SofteningBank::add(const element::ElementDescription& description,
                        std::shared_ptr<const element::ForceEffect> law) {
  const std::size_t i = laws_.size() % SofteningBlock::kSize;
  if (i == 0) {
    blocks_.emplace_back();
  }
  const auto inverse = [&](const char* name) {
    return description.value(name) > 0.0 ? 1.0 / description.value(name) : 0.0;
  };
  SofteningBlock& block = blocks_.back();
  const double per_width = inverse("width");
  const double by_reach = description.value("reach_exponent");
  block.reduction[i] = description.value("reduction") / std::tanh(per_width);
  block.steepness[i] = 2.0 * per_width;
  (description.value("ratio_power") == 1.0 ? block.by_ratio : block.by_square)[i] = 1.0;
  (by_reach == 0.0 ? block.evenly : by_reach == 1.0 ? block.by_reach : block.by_reach_squared)[i] = 1.0;
  block.inverse_full_reach[i] = inverse("full_reach");
  block.side[i] = description.value("side");
  block.inverse_path[i] = inverse("path");
  block.recovery_rate[i] = inverse("recovery_time");
  block.recovers = block.recovers || block.recovery_rate[i] > 0.0;
  laws_.push_back(std::move(law));
}

bool SofteningBank::acceptsMemory(const double* memory) const {
  bool accepts = true;
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    accepts = accepts && laws_[i]->acceptsMemory(memory + kSlots * i);
  }
  return accepts;
}

void SofteningBank::initialise(double displacement, double* memory) const {
  for (const auto& law : laws_) {
    law->initialise(displacement, memory);
    memory += kSlots;
  }
}

double SofteningBank::relax(double displacement, double* memory) const {
  double product = 1.0;
  for (const auto& law : laws_) {
    product *= law->relax(displacement, memory);
    memory += kSlots;
  }
  return product;
}

double SofteningBank::step(const element::Motion& motion, const element::ComponentForce& force, double* memory) const {
  if (laws_.size() == 1) {
    return laws_.front()->step(motion, force, memory);
  }
  return RUBBER_SUSPENSION_KERNEL(softenedProduct)(blocks_.data(), laws_.size(), motion.dt, motion.displacement,
                                                   motion.increment, memory);
}

}  // namespace rubber_suspension::kernel
