// A component's signal path from displacement to force.
#include "rubber_suspension/component/component.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <stdexcept>

#include "rubber_suspension/element/dashpot.h"
#include "rubber_suspension/element/spring.h"

namespace rubber_suspension {
namespace {

void add(ComponentForce& sum, Part part, double force) {
  switch (part) {
    case Part::elastic:
      sum.elastic += force;
      break;
    case Part::viscous:
      sum.viscous += force;
      break;
    case Part::friction:
      sum.friction += force;
      break;
  }
  sum.total += force;
}

void scale(ComponentForce& force, double factor) {
  force.total *= factor;
  force.elastic *= factor;
  force.viscous *= factor;
  force.friction *= factor;
}

// Root of mismatch(z) = z + compliance F(z) - z_actuator. As no element has a negative tangent stiffness the slope is 1
// or more, so the root lies between the guess and the guess less its mismatch.
template <class Mismatch>
double solveSeries(Mismatch mismatch, double guess) {
  const double at_guess = mismatch(guess);
  if (at_guess == 0.0 || !std::isfinite(at_guess)) {
    return guess;
  }
  const double other = guess - at_guess;
  const double at_other = mismatch(other);
  if (at_other == 0.0 || (at_other > 0.0) == (at_guess > 0.0)) {
    return other;  // equal signs only by rounding: the mismatch is at its last bits
  }
  const bool ascending = other > guess;
  boost::uintmax_t iterations = 60;
  const auto bracket = boost::math::tools::toms748_solve(
      mismatch, ascending ? guess : other, ascending ? other : guess, ascending ? at_guess : at_other,
      ascending ? at_other : at_guess, boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace

void ComponentState::restore(double displacement, const std::vector<double>& memory) {
  if (memory.size() != memory_.size()) {
    throw std::invalid_argument(
        fmt::format("state has {} numbers, this component needs {}", memory.size(), memory_.size()));
  }
  const bool finite = std::isfinite(displacement) &&
                      std::all_of(memory.begin(), memory.end(), [](double value) { return std::isfinite(value); });
  if (!finite) {
    throw std::invalid_argument("state holds numbers that are not finite");
  }
  displacement_ = displacement;
  std::copy(memory.begin(), memory.end(), memory_.begin());
}

Component::Component(const std::vector<ElementDescription>& elements) {
  std::vector<ElementPointer> made;
  for (const ElementDescription& description : elements) {
    descriptions_.push_back(complete(description));
    made.push_back(makeElement(description));
    if (const auto* law = std::get_if<std::shared_ptr<const ParallelElement>>(&made.back())) {
      if (const auto* maxwell = dynamic_cast<const Maxwell*>(law->get())) {
        maxwells_.push_back({maxwell->stiffness(), maxwell->relaxationTime()});
      }
    }
  }
  memory_size_ = maxwells_.size();
  for (const ElementPointer& element : made) {
    place(element);
  }
  if (!displacement_effects_.empty()) {
    behind_effects_slot_ = reserve(1);
  }
  if (mount_compliance_ > 0.0) {
    behind_mount_slot_ = reserve(1);
  }
}

std::size_t Component::reserve(std::size_t size) {
  const std::size_t offset = memory_size_;
  memory_size_ += size;
  return offset;
}

void Component::place(const ElementPointer& element) {
  if (const auto* effect = std::get_if<std::shared_ptr<const DisplacementEffect>>(&element)) {
    displacement_effects_.push_back({*effect, reserve((*effect)->memorySize())});
  } else if (const auto* factor = std::get_if<std::shared_ptr<const ForceEffect>>(&element)) {
    force_effects_.push_back({*factor, reserve((*factor)->memorySize())});
  } else if (const auto* mount = std::get_if<std::shared_ptr<const SeriesElement>>(&element)) {
    mount_compliance_ += 1.0 / (*mount)->stiffness();
  } else {
    const auto& law = std::get<std::shared_ptr<const ParallelElement>>(element);
    if (const auto* spring = dynamic_cast<const Spring*>(law.get())) {
      spring_stiffness_ += spring->stiffness();
    } else if (const auto* dashpot = dynamic_cast<const Dashpot*>(law.get())) {
      dashpot_damping_ += dashpot->damping();
    } else if (dynamic_cast<const Maxwell*>(law.get()) == nullptr) {
      (law->onRig() ? rig_ : specimen_).push_back({law, reserve(law->memorySize())});
    }
  }
}

ComponentState Component::makeState() const {
  ComponentState state;
  state.memory_.resize(memory_size_);
  state.scratch_.resize(mount_compliance_ > 0.0 ? memory_size_ : 0);
  state.maxwell_steps_.resize(maxwells_.size());
  rest(state, 0.0);
  return state;
}

void Component::prepare(ComponentState& state, double dt) const {
  if (dt == state.prepared_dt_) {
    return;
  }
  for (std::size_t i = 0; i < maxwells_.size(); ++i) {
    state.maxwell_steps_[i] = MaxwellStep(maxwells_[i].stiffness, maxwells_[i].relaxation_time, dt);
  }
  state.prepared_dt_ = dt;
}

ComponentForce Component::specimenRest(double displacement, double* memory) const {
  std::fill(memory, memory + maxwells_.size(), 0.0);
  ComponentForce force;
  force.elastic = force.total = spring_stiffness_ * displacement;
  for (const auto& element : specimen_) {
    add(force, element.law->part(), element.law->rest(displacement, memory + element.offset));
  }
  for (const auto& effect : force_effects_) {
    effect.law->rest(displacement, memory + effect.offset);
  }
  return force;
}

ComponentForce Component::specimenStep(const ComponentState& state, const Motion& motion, double* memory) const {
  ComponentForce force;
  force.elastic = spring_stiffness_ * motion.displacement;
  force.viscous = dashpot_damping_ * (motion.increment / motion.dt);
  for (std::size_t i = 0; i < maxwells_.size(); ++i) {
    const MaxwellStep& coefficients = state.maxwell_steps_[i];
    memory[i] = coefficients.decay * memory[i] + coefficients.gain * motion.increment;
    force.viscous += memory[i];
  }
  force.total = force.elastic + force.viscous;
  for (const auto& element : specimen_) {
    add(force, element.law->part(), element.law->step(motion, memory + element.offset));
  }
  for (const auto& effect : force_effects_) {
    scale(force, effect.law->step(motion, force, memory + effect.offset));
  }
  return force;
}

double Component::behindMountAtRest(ComponentState& state, double displacement) const {
  return solveSeries(
      [&](double specimen) {
        return specimen + mount_compliance_ * specimenRest(specimen, state.scratch_.data()).total - displacement;
      },
      displacement);
}

double Component::behindMount(ComponentState& state, const Motion& motion) const {
  const double before = state.memory_[behind_mount_slot_];
  return solveSeries(
      [&](double specimen) {
        std::copy(state.memory_.begin(), state.memory_.end(), state.scratch_.begin());
        const Motion trial{motion.dt, specimen, specimen - before};
        return specimen + mount_compliance_ * specimenStep(state, trial, state.scratch_.data()).total -
               motion.displacement;
      },
      before + motion.increment);
}

ComponentForce Component::rest(ComponentState& state, double displacement) const {
  double* memory = state.memory_.data();
  double specimen = displacement;
  for (const auto& effect : displacement_effects_) {
    specimen = effect.law->rest(specimen, memory + effect.offset);
  }
  if (!displacement_effects_.empty()) {
    memory[behind_effects_slot_] = specimen;
  }
  if (mount_compliance_ > 0.0) {
    specimen = behindMountAtRest(state, specimen);
    memory[behind_mount_slot_] = specimen;
  }
  ComponentForce force = specimenRest(specimen, memory);
  for (const auto& element : rig_) {
    add(force, element.law->part(), element.law->rest(displacement, memory + element.offset));
  }
  state.displacement_ = displacement;
  return force;
}

ComponentForce Component::step(ComponentState& state, double dt, double displacement) const {
  prepare(state, dt);
  double* memory = state.memory_.data();
  const Motion actuator{dt, displacement, displacement - state.displacement_};
  Motion specimen = actuator;
  if (!displacement_effects_.empty()) {
    for (const auto& effect : displacement_effects_) {
      specimen.displacement = effect.law->step(specimen, memory + effect.offset);
    }
    specimen.increment = specimen.displacement - memory[behind_effects_slot_];
    memory[behind_effects_slot_] = specimen.displacement;
  }
  if (mount_compliance_ > 0.0) {
    specimen.displacement = behindMount(state, specimen);
    specimen.increment = specimen.displacement - memory[behind_mount_slot_];
    memory[behind_mount_slot_] = specimen.displacement;
  }
  ComponentForce force = specimenStep(state, specimen, memory);
  for (const auto& element : rig_) {
    add(force, element.law->part(), element.law->step(actuator, memory + element.offset));
  }
  state.displacement_ = displacement;
  return force;
}

bool Component::linear() const { return complexStiffness(1.0).has_value(); }

std::optional<std::complex<double>> Component::complexStiffness(double frequency) const {
  if (!force_effects_.empty()) {
    return std::nullopt;
  }
  const double omega = 2.0 * M_PI * frequency;
  std::complex<double> specimen(spring_stiffness_, omega * dashpot_damping_);
  for (const auto& maxwell : maxwells_) {
    const std::complex<double> iwt(0.0, omega * maxwell.relaxation_time);
    specimen += maxwell.stiffness * iwt / (1.0 + iwt);
  }
  for (const auto& element : specimen_) {
    const auto stiffness = element.law->complexStiffness(omega);
    if (!stiffness) {
      return std::nullopt;
    }
    specimen += *stiffness;
  }
  std::complex<double> total = specimen / (1.0 + mount_compliance_ * specimen);
  for (const auto& effect : displacement_effects_) {
    const auto transfer = effect.law->transfer(omega);
    if (!transfer) {
      return std::nullopt;
    }
    total *= *transfer;
  }
  for (const auto& element : rig_) {
    const auto stiffness = element.law->complexStiffness(omega);
    if (!stiffness) {
      return std::nullopt;
    }
    total += *stiffness;
  }
  return total;
}

}  // namespace rubber_suspension
