// Many components of one build, eight side by side.
#include "rubber_suspension/component/fleet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "component/fleet_numbers.h"
#include "rubber_suspension/element/dashpot.h"
#include "rubber_suspension/element/maxwell_bank.h"
#include "rubber_suspension/element/spring.h"
#define RUBBER_SUSPENSION_LAYER component
#define RUBBER_SUSPENSION_KERNELS "component/fleet_kernels.h"
#include "kernel/instruction_sets.h"

namespace rubber_suspension::component {
namespace {

[[noreturn]] void refuse(std::size_t index, const std::string& reason) {
  throw std::invalid_argument(fmt::format("component {} of the fleet: {}", index + 1, reason));
}

}  // namespace

ComponentFleet::ComponentFleet(const std::vector<component::Component>& components) : size_(components.size()) {
  for (const component::Component& component : components) {
    try {
      laws_.push_back(lawsOf(component));
    } catch (const std::invalid_argument& error) {
      refuse(laws_.size(), error.what());
    }
    if (laws_.back().maxwells.size() != laws_.front().maxwells.size()) {
      refuse(laws_.size() - 1, fmt::format("{} Maxwell elements; accepted: {}, as the first one has",
                                           laws_.back().maxwells.size(), laws_.front().maxwells.size()));
    }
    if (laws_.back().bergs.size() != laws_.front().bergs.size()) {
      refuse(laws_.size() - 1, fmt::format("{} elements of friction; accepted: {}, as the first one has",
                                           laws_.back().bergs.size(), laws_.front().bergs.size()));
    }
  }
  if (laws_.empty()) {
    return;
  }
  laws_.resize((size_ + kLanes - 1) / kLanes * kLanes, laws_.back());
  maxwells_ = laws_.front().maxwells.size();
  rows_ = kFirstMaxwell + maxwells_ * kMaxwellRows;
  numbers_.resize(rows_ * laws_.size() / kLanes);
  displacement_.resize(size_);
  turn_together_ = std::all_of(laws_.begin(), laws_.end(), [this](const Laws& laws) {
    return laws.bergs.empty() || laws.bergs.front().deadBand() == laws_.front().bergs.front().deadBand();
  });
  initialise(0.0);
}

ComponentFleet::Laws ComponentFleet::lawsOf(const component::Component& component) {
  Laws laws;
  for (const element::ElementDescription& description : component.elements()) {
    const element::ElementPointer element = element::makeElement(description);
    const auto* parallel = std::get_if<std::shared_ptr<const element::ParallelElement>>(&element);
    const element::ParallelElement* law = parallel != nullptr ? parallel->get() : nullptr;
    if (const auto* spring = dynamic_cast<const element::Spring*>(law)) {
      laws.spring_stiffness += spring->stiffness();
    } else if (const auto* dashpot = dynamic_cast<const element::Dashpot*>(law)) {
      laws.damping += dashpot->damping();
    } else if (const auto* maxwell = dynamic_cast<const element::Maxwell*>(law)) {
      laws.maxwells.push_back(*maxwell);
    } else if (const auto* bank = dynamic_cast<const element::MaxwellBank*>(law)) {
      laws.maxwells.insert(laws.maxwells.end(), bank->elements().begin(), bank->elements().end());
    } else if (const auto* berg = dynamic_cast<const element::BergFriction*>(law)) {
      laws.bergs.push_back(*berg);
    } else {
      throw std::invalid_argument(description.type + "; accepted: springs, dashpots, Maxwell elements, Berg friction");
    }
  }
  if (laws.bergs.size() > 1) {
    throw std::invalid_argument("two elements of friction; accepted: one at most");
  }
  return laws;
}

LaneRow* ComponentFleet::group(std::size_t first_lane) { return numbers_.data() + first_lane / kLanes * rows_; }

double& ComponentFleet::number(std::size_t lane, std::size_t row) { return group(lane)[row].lane[lane % kLanes]; }

void ComponentFleet::initialise(double displacement) {
  std::fill(numbers_.begin(), numbers_.end(), LaneRow{});
  for (std::size_t lane = 0; lane < laws_.size(); ++lane) {
    number(lane, kDisplacement) = displacement;
    number(lane, kSpring) = laws_[lane].spring_stiffness;
    for (const element::BergFriction& berg : laws_[lane].bergs) {
      number(lane, kMaximumForce) = berg.maximumForce();
      number(lane, kCompliance) = berg.compliance();
      number(lane, kDeadBand) = berg.deadBand();
      std::array<double, element::BergFriction::kMemorySize> memory{};
      berg.initialise(displacement, memory.data());
      for (std::size_t k = 0; k < memory.size(); ++k) {
        number(lane, kReferenceDisplacement + k) = memory[k];
      }
    }
  }
  prepared_dt_ = -1.0;
  moved_together_ = true;
}

void ComponentFleet::prepare(double dt) {
  for (std::size_t lane = 0; lane < laws_.size(); ++lane) {
    number(lane, kDashpot) = laws_[lane].damping / dt;
    for (std::size_t k = 0; k < maxwells_; ++k) {
      const element::Maxwell& maxwell = laws_[lane].maxwells[k];
      const element::MaxwellStep step(maxwell.stiffness(), element::Relaxation::over(dt * maxwell.rate()));
      number(lane, kFirstMaxwell + kMaxwellRows * k + kDecay) = step.decay;
      number(lane, kFirstMaxwell + kMaxwellRows * k + kGain) = step.gain;
    }
  }
  prepared_dt_ = dt;
}

bool ComponentFleet::frictional() const { return !laws_.empty() && !laws_.front().bergs.empty(); }

FleetGroups ComponentFleet::groups(std::size_t first_lane, std::size_t lanes) {
  return {group(first_lane), lanes / kLanes, rows_, maxwells_, frictional()};
}

void ComponentFleet::stepEach(double dt, const double* displacement, double* force) {
  if (dt != prepared_dt_) {
    prepare(dt);
  }
  const auto step_groups = RUBBER_SUSPENSION_KERNEL(stepGroups);
  const std::size_t whole = size_ / kLanes * kLanes;
  step_groups(groups(0, whole), displacement, force);
  if (whole < size_) {
    std::array<double, kLanes> numbers{};
    std::copy(displacement + whole, displacement + size_, numbers.begin());
    step_groups(groups(whole, kLanes), numbers.data(), numbers.data());
    std::copy_n(numbers.begin(), size_ - whole, force + whole);
  }
}

void ComponentFleet::step(double dt, const double* displacement, double* force) {
  moved_together_ = false;
  stepEach(dt, displacement, force);
}

void ComponentFleet::step(double dt, double displacement, double* force) {
  std::fill(displacement_.begin(), displacement_.end(), displacement);
  stepEach(dt, displacement_.data(), force);
}

void ComponentFleet::simulate(double dt, const double* displacement, std::size_t count, double* force) {
  if (size_ == 0) {
    return;
  }
  if (!moved_together_ || !turn_together_ || maxwells_ > kMostMaxwells) {
    for (std::size_t i = 0; i < count; ++i) {
      step(dt, displacement[i], force + i * size_);
    }
    return;
  }
  if (dt != prepared_dt_) {
    prepare(dt);
  }
  for (std::size_t first = 0; first < count; first += LogBlock::kMost) {
    simulateBlock(displacement + first, std::min(LogBlock::kMost, count - first), force + first * size_);
  }
}

void ComponentFleet::simulateBlock(const double* displacement, std::size_t count, double* force) {
  LogBlock block(displacement, count, number(0, kDisplacement));
  if (frictional()) {
    block.findStretches(laws_.front().bergs.front(), group(0));
  }
  const auto simulate_groups = RUBBER_SUSPENSION_KERNEL(simulateGroups);
  const std::size_t whole = size_ / kLanes * kLanes;
  simulate_groups(groups(0, whole), block, force, size_);
  if (whole < size_) {
    std::array<double, LogBlock::kMost * kLanes> forces;
    simulate_groups(groups(whole, kLanes), block, forces.data(), kLanes);
    for (std::size_t i = 0; i < count; ++i) {
      std::copy_n(forces.begin() + i * kLanes, size_ - whole, force + whole + i * size_);
    }
  }
}

}  // namespace rubber_suspension::component
