// Springs, dashpots, Maxwell elements and Berg friction in parallel: parameters, initial state, complex stiffness.
#include "rubber_suspension/kernel/basic_laws_kernel.h"

#include <algorithm>

namespace rubber_suspension::kernel {

using element::BergFriction;

BasicLawsKernel::BasicLawsKernel(const element::BasicLaws& laws)
    : spring_stiffness_(laws.stiffness), damping_(laws.damping), maxwell_count_(laws.maxwells.size()) {
  for (const element::BasicLaws::MaxwellNumbers& maxwell : laws.maxwells) {
    maxwell_stiffness_.push_back(maxwell.stiffness);
    maxwell_rate_.push_back(maxwell.rate);
    fastest_rate_ = std::max(fastest_rate_, maxwell.rate);
  }
  // There is at least one block, so that its address is valid.
  const std::size_t blocks = std::max<std::size_t>(1, (maxwell_count_ + MaxwellBlock::kSize - 1) / MaxwellBlock::kSize);
  maxwell_stiffness_.resize(blocks * MaxwellBlock::kSize);
  maxwell_rate_.resize(blocks * MaxwellBlock::kSize);
  for (const element::BasicLaws::FrictionNumbers& friction : laws.frictions) {
    frictions_.emplace_back(friction.maximum_force, friction.displacement, friction.dead_band);
  }
}

PreparedStep BasicLawsKernel::makePreparedStep() const {
  PreparedStep prepared;
  prepared.spring_stiffness = spring_stiffness_;
  prepared.friction_count = static_cast<std::uint32_t>(frictions_.size());
  prepared.maxwell_count = static_cast<std::uint32_t>(maxwell_count_);
  prepared.maxwells.resize(maxwell_stiffness_.size() / MaxwellBlock::kSize);
  return prepared;
}

element::ComponentForce BasicLawsKernel::initialise(double displacement, double* memory) const {
  std::fill(memory, memory + maxwell_count_, 0.0);
  element::ComponentForce force;
  force.elastic = force.total = spring_stiffness_ * displacement;
  double* friction_memory = frictionMemory(memory);
  for (const BergFriction& friction : frictions_) {
    const double friction_force = friction.initialise(displacement, friction_memory);
    force.friction += friction_force;
    force.total += friction_force;
    friction_memory += BergFriction::kMemorySize;
  }
  return force;
}

element::ComponentForce BasicLawsKernel::step(double dt, double displacement, double increment, double* memory,
                                              PreparedStep& prepared) const {
  if (dt != prepared.dt) {
    prepare(dt, prepared);
  }
  if (prepared.continues(dt, displacement, memory)) {
    return prepared.continueTo(displacement, increment, memory);
  }
  if (frictions_.size() > 1) {
    return stepWithoutBranch({dt, displacement, increment}, memory, prepared);
  }
  double* own = frictionMemory(memory);
  const double friction = frictions_.front().advance(displacement, own);
  prepared.branch = frictions_.front().currentBranch(own);
  return prepared.advance(displacement, increment, friction, memory);
}

std::optional<std::complex<double>> BasicLawsKernel::complexStiffness(double omega) const {
  if (!frictions_.empty()) {
    return std::nullopt;
  }
  std::complex<double> sum(spring_stiffness_, omega * damping_);
  for (std::size_t i = 0; i < maxwell_count_; ++i) {
    const std::complex<double> iwt(0.0, omega / maxwell_rate_[i]);
    sum += maxwell_stiffness_[i] * iwt / (1.0 + iwt);
  }
  return sum;
}

}  // namespace rubber_suspension::kernel
