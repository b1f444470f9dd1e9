// Many components of one build at each tick. The laws are those of Component::step, written for eight lanes; that
// pointers do not overlap is said by __restrict, without which the loops over the lanes are no vector instructions.
#include "rubber_suspension/component/fleet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rubber_suspension/element/dashpot.h"
#include "rubber_suspension/element/maxwell_bank.h"
#include "rubber_suspension/element/spring.h"

namespace rubber_suspension {
namespace {

constexpr std::size_t kLanes = 8;

// Rows of a group. The friction's memory is in the order of BergFriction's; after it three rows per Maxwell element.
enum Row : std::size_t {
  kDisplacement,
  kSpring,
  kDashpot,
  kMaximumForce,
  kCompliance,
  kReferenceDisplacement,
  kReferenceForce,
  kExtremum,
  kDirection,
  kFirstMaxwell
};
enum MaxwellRow : std::size_t { kDecay, kGain, kForce, kMaxwellRows };

// A function of this kind is unfolded where it is called, so that it is compiled for the processor of its caller.
#define RUBBER_SUSPENSION_UNFOLD [[gnu::always_inline]] inline

// Sums of spring, dashpot and Maxwell forces.
RUBBER_SUSPENSION_UNFOLD void stepLinear(double* __restrict group, std::size_t maxwells,
                                         const double* __restrict displacement, double* __restrict elastic,
                                         double* __restrict viscous) {
  double increment[kLanes];
  for (std::size_t i = 0; i < kLanes; ++i) {
    increment[i] = displacement[i] - group[kDisplacement * kLanes + i];
    group[kDisplacement * kLanes + i] = displacement[i];
    elastic[i] = group[kSpring * kLanes + i] * displacement[i];
    viscous[i] = group[kDashpot * kLanes + i] * increment[i];
  }
  double* element = group + kFirstMaxwell * kLanes;
  for (std::size_t k = 0; k < maxwells; ++k, element += kMaxwellRows * kLanes) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      const double force =
          element[kDecay * kLanes + i] * element[kForce * kLanes + i] + element[kGain * kLanes + i] * increment[i];
      element[kForce * kLanes + i] = force;
      viscous[i] += force;
    }
  }
}

// Moves the extremum of each lane along; false where one of them has not gone on along its branch.
RUBBER_SUSPENSION_UNFOLD bool goOn(double* __restrict group, const double* displacement) {
  double least = 1.0;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double beyond = (displacement[i] - group[kExtremum * kLanes + i]) * group[kDirection * kLanes + i];
    least = std::min(least, beyond);
  }
  if (!(least > 0.0)) {
    return false;
  }
  std::copy_n(displacement, kLanes, group + kExtremum * kLanes);
  return true;
}

// Each lane by the law of one component: turns, pauses, what is not a number.
void advanceOneByOne(double* group, const BergFriction* bergs, const double* displacement, double* friction) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    std::array<double, BergFriction::kMemorySize> memory{};
    for (std::size_t k = 0; k < memory.size(); ++k) {
      memory[k] = group[(kReferenceDisplacement + k) * kLanes + i];
    }
    friction[i] = bergs[i].advance(displacement[i], memory.data());
    for (std::size_t k = 0; k < memory.size(); ++k) {
      group[(kReferenceDisplacement + k) * kLanes + i] = memory[k];
    }
  }
}

// Both branches of Berg's law in one, as BergFriction has them.
RUBBER_SUSPENSION_UNFOLD void follow(const double* __restrict group, const double* __restrict displacement,
                                     double* __restrict friction) {
  constexpr double kTiny = std::numeric_limits<double>::min();
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double reference_force = group[kReferenceForce * kLanes + i];
    const double way = displacement[i] - group[kReferenceDisplacement * kLanes + i];
    const double left = std::copysign(group[kMaximumForce * kLanes + i], way) - reference_force;
    const double reach = group[kCompliance * kLanes + i] * std::abs(left);
    friction[i] = reference_force + std::abs(way) * left / (reach + std::abs(way) + kTiny);
  }
}

RUBBER_SUSPENSION_UNFOLD void stepGroup(double* __restrict group, std::size_t maxwells, const BergFriction* bergs,
                                        const double* __restrict displacement, double* __restrict force) {
  double elastic[kLanes];
  double viscous[kLanes];
  double friction[kLanes] = {};
  stepLinear(group, maxwells, displacement, elastic, viscous);
  if (bergs != nullptr) {
    if (goOn(group, displacement)) {
      follow(group, displacement, friction);
    } else {
      advanceOneByOne(group, bergs, displacement, friction);
    }
  }
  for (std::size_t i = 0; i < kLanes; ++i) {
    force[i] = elastic[i] + viscous[i] + friction[i];
  }
}

// All groups at one tick.
struct Tick {
  double* numbers;
  std::size_t rows;
  std::size_t maxwells;
  const BergFriction* bergs;  // of all lanes; none: nullptr
  const double* displacement;
  double* force;
  std::size_t size;  // of the fleet
};

RUBBER_SUSPENSION_UNFOLD void stepGroups(const Tick& tick) {
  double* group = tick.numbers;
  const BergFriction* bergs = tick.bergs;
  std::size_t first = 0;
  for (; first + kLanes <= tick.size; first += kLanes) {
    stepGroup(group, tick.maxwells, bergs, tick.displacement + first, tick.force + first);
    group += tick.rows * kLanes;
    bergs = bergs == nullptr ? nullptr : bergs + kLanes;
  }
  if (first < tick.size) {
    double displacement[kLanes];
    double force[kLanes];
    const std::size_t rest = tick.size - first;
    std::copy_n(tick.displacement + first, rest, displacement);
    std::fill(displacement + rest, displacement + kLanes, displacement[rest - 1]);
    stepGroup(group, tick.maxwells, bergs, displacement, force);
    std::copy_n(force, rest, tick.force + first);
  }
}

void stepGroupsAnywhere(const Tick& tick) { stepGroups(tick); }

using StepGroups = void (*)(const Tick&);

#ifdef __x86_64__
__attribute__((target("avx2"))) void stepGroupsAvx2(const Tick& tick) { stepGroups(tick); }

StepGroups fastest() { return __builtin_cpu_supports("avx2") != 0 ? stepGroupsAvx2 : stepGroupsAnywhere; }
#else
StepGroups fastest() { return stepGroupsAnywhere; }
#endif

[[noreturn]] void refuse(std::size_t index, const std::string& reason) {
  throw std::invalid_argument(fmt::format("component {} of the fleet: {}", index + 1, reason));
}

}  // namespace

ComponentFleet::ComponentFleet(const std::vector<Component>& components) : size_(components.size()) {
  for (const Component& component : components) {
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
  numbers_.resize(rows_ * laws_.size());
  displacement_.resize(size_);
  for (const Laws& laws : laws_) {
    bergs_.insert(bergs_.end(), laws.bergs.begin(), laws.bergs.end());
  }
  rest(0.0);
}

ComponentFleet::Laws ComponentFleet::lawsOf(const Component& component) {
  Laws laws;
  for (const ElementDescription& description : component.elements()) {
    const ElementPointer element = makeElement(description);
    const auto* parallel = std::get_if<std::shared_ptr<const ParallelElement>>(&element);
    const ParallelElement* law = parallel != nullptr ? parallel->get() : nullptr;
    if (const auto* spring = dynamic_cast<const Spring*>(law)) {
      laws.spring_stiffness += spring->stiffness();
    } else if (const auto* dashpot = dynamic_cast<const Dashpot*>(law)) {
      laws.damping += dashpot->damping();
    } else if (const auto* maxwell = dynamic_cast<const Maxwell*>(law)) {
      laws.maxwells.push_back(*maxwell);
    } else if (const auto* bank = dynamic_cast<const MaxwellBank*>(law)) {
      laws.maxwells.insert(laws.maxwells.end(), bank->elements().begin(), bank->elements().end());
    } else if (const auto* berg = dynamic_cast<const BergFriction*>(law)) {
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

double& ComponentFleet::number(std::size_t lane, std::size_t row) {
  return numbers_[(lane / kLanes * rows_ + row) * kLanes + lane % kLanes];
}

void ComponentFleet::rest(double displacement) {
  std::fill(numbers_.begin(), numbers_.end(), 0.0);
  for (std::size_t lane = 0; lane < laws_.size(); ++lane) {
    number(lane, kDisplacement) = displacement;
    number(lane, kSpring) = laws_[lane].spring_stiffness;
    if (!bergs_.empty()) {
      const BergFriction& berg = bergs_[lane];
      number(lane, kMaximumForce) = berg.maximumForce();
      number(lane, kCompliance) = berg.displacement() / berg.maximumForce();
      std::array<double, BergFriction::kMemorySize> memory{};
      berg.rest(displacement, memory.data());
      for (std::size_t k = 0; k < memory.size(); ++k) {
        number(lane, kReferenceDisplacement + k) = memory[k];
      }
    }
  }
  prepared_dt_ = -1.0;
}

void ComponentFleet::prepare(double dt) {
  for (std::size_t lane = 0; lane < laws_.size(); ++lane) {
    number(lane, kDashpot) = laws_[lane].damping / dt;
    for (std::size_t k = 0; k < maxwells_; ++k) {
      const Maxwell& maxwell = laws_[lane].maxwells[k];
      const MaxwellStep step(maxwell.stiffness(), Relaxation::over(dt * maxwell.rate()));
      number(lane, kFirstMaxwell + kMaxwellRows * k + kDecay) = step.decay;
      number(lane, kFirstMaxwell + kMaxwellRows * k + kGain) = step.gain;
    }
  }
  prepared_dt_ = dt;
}

void ComponentFleet::step(double dt, const double* displacement, double* force) {
  if (dt != prepared_dt_) {
    prepare(dt);
  }
  static const StepGroups kStepGroups = fastest();
  kStepGroups(
      {numbers_.data(), rows_, maxwells_, bergs_.empty() ? nullptr : bergs_.data(), displacement, force, size_});
}

void ComponentFleet::step(double dt, double displacement, double* force) {
  std::fill(displacement_.begin(), displacement_.end(), displacement);
  step(dt, displacement_.data(), force);
}

}  // namespace rubber_suspension
