// A component's signal path from displacement to force.
#include "rubber_suspension/component/component.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rubber_suspension/element/dashpot.h"
#include "rubber_suspension/element/maxwell_bank.h"
#include "rubber_suspension/element/spring.h"

namespace rubber_suspension::component {
namespace {

void add(element::ComponentForce& sum, element::Part part, double force) {
  switch (part) {
    case element::Part::elastic:
      sum.elastic += force;
      break;
    case element::Part::viscous:
      sum.viscous += force;
      break;
    case element::Part::friction:
      sum.friction += force;
      break;
  }
  sum.total += force;
}

void scale(element::ComponentForce& force, double factor) {
  force.total *= factor;
  force.elastic *= factor;
  force.viscous *= factor;
  force.friction *= factor;
}

struct Sample {
  double position;
  double value;
};

// Root between two samples of unlike signs by the method of Anderson and Bjorck (BIT 13, 1973): secants, the end that
// stays weighed down such that both ends close in. It ends where the value is rounding, or the bracket has no inside.
template <class Function>
double root(Function function, Sample stays, Sample latest) {
  constexpr double kRounding = 2.0 * std::numeric_limits<double>::epsilon();
  constexpr int kMostSteps = 100;
  for (int i = 0; i < kMostSteps; ++i) {
    const double slope = (latest.value - stays.value) / (latest.position - stays.position);
    const double position = latest.position - latest.value / slope;
    if (position == latest.position || position == stays.position) {
      return position;
    }
    const Sample next{position, function(position)};
    if (!(std::abs(next.value) > kRounding * std::abs(position))) {
      return position;
    }
    if (next.value * latest.value < 0.0) {
      stays = latest;
    } else {
      const double share = 1.0 - next.value / latest.value;
      stays.value *= share > 0.0 ? share : 0.5;
    }
    latest = next;
  }
  return latest.position;
}

// Root of mismatch(z) = z + compliance F(z) - z_actuator next to the guess. Where its slope is nowhere less than the
// least slope (1 where no tangent stiffness is negative) the root lies between the guess and the guess less its
// mismatch over that slope; otherwise a step or more beyond, each twice as far. NaN where there is none: the specimen
// has given way.
template <class Mismatch>
double solveSeries(Mismatch mismatch, double guess, double least_slope = 1.0) {
  constexpr int kWidenings = 60;
  const double at_guess = mismatch(guess);
  if (at_guess == 0.0 || !std::isfinite(at_guess)) {
    return guess;
  }
  double other = guess - at_guess / least_slope;
  double at_other = mismatch(other);
  // Equal signs may come from rounding alone, when the mismatch is at its last bits.
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * (std::abs(guess) + std::abs(other));
  for (int i = 0; i < kWidenings && at_other * at_guess > 0.0 && std::abs(at_other) > rounding; ++i) {
    other = guess + 2.0 * (other - guess);
    at_other = mismatch(other);
  }
  if (std::abs(at_other) <= rounding) {
    return other;
  }
  if (!(at_other * at_guess < 0.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return root(mismatch, {guess, at_guess}, {other, at_other});
}

}  // namespace

void ComponentState::deserialise(double displacement, const std::vector<double>& memory) {
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
  branch_ = {};
}

Component::Component(const std::vector<element::ElementDescription>& elements) {
  for (const element::ElementDescription& description : elements) {
    descriptions_.push_back(element::complete(description));
    const element::ElementPointer element = element::makeElement(description);
    if (const auto* effect = std::get_if<std::shared_ptr<const element::DisplacementEffect>>(&element)) {
      displacement_effects_.push_back({*effect, 0});
    } else if (const auto* factor = std::get_if<std::shared_ptr<const element::ForceEffect>>(&element)) {
      force_effects_.push_back({*factor, 0});
    } else if (const auto* mount = std::get_if<std::shared_ptr<const element::SeriesElement>>(&element)) {
      placeMount(*mount);
    } else {
      const auto& law = std::get<std::shared_ptr<const element::ParallelElement>>(element);
      if (law->onRig()) {
        rig_.push_back({law, 0});
      } else {
        placeSpecimen(law);
      }
    }
  }
  reserveMemory();
}

void Component::placeMount(const std::shared_ptr<const element::SeriesElement>& mount) {
  mounted_ = true;
  if (const auto compliance = mount->compliance()) {
    mount_compliance_.tension += compliance->tension;
    mount_compliance_.compression += compliance->compression;
  } else {
    joints_.push_back(mount);
  }
}

void Component::placeSpecimen(const std::shared_ptr<const element::ParallelElement>& law) {
  const auto addMaxwell = [this](const element::Maxwell& maxwell) {
    maxwell_stiffness_.push_back(maxwell.stiffness());
    maxwell_rate_.push_back(maxwell.rate());
    fastest_rate_ = std::max(fastest_rate_, maxwell.rate());
  };
  if (const auto* spring = dynamic_cast<const element::Spring*>(law.get())) {
    spring_stiffness_ += spring->stiffness();
  } else if (const auto* dashpot = dynamic_cast<const element::Dashpot*>(law.get())) {
    dashpot_damping_ += dashpot->damping();
  } else if (const auto* maxwell = dynamic_cast<const element::Maxwell*>(law.get())) {
    addMaxwell(*maxwell);
  } else if (const auto* bank = dynamic_cast<const element::MaxwellBank*>(law.get())) {
    std::for_each(bank->elements().begin(), bank->elements().end(), addMaxwell);
  } else if (const auto* berg = dynamic_cast<const element::BergFriction*>(law.get())) {
    bergs_.push_back(*berg);
  } else {
    specimen_.push_back({law, 0});
  }
}

template <class Law>
void Component::placeAll(std::vector<Placed<Law>>& placed) {
  for (Placed<Law>& element : placed) {
    element.offset = reserve(element.law->memorySize());
  }
}

void Component::reserveMemory() {
  maxwells_ = maxwell_stiffness_.size();
  reserve(maxwells_);
  // One at least, so that there is something to point to.
  const std::size_t blocks =
      std::max<std::size_t>(1, (maxwells_ + kernel::MaxwellBlock::kSize - 1) / kernel::MaxwellBlock::kSize);
  maxwell_stiffness_.resize(blocks * kernel::MaxwellBlock::kSize);
  maxwell_rate_.resize(blocks * kernel::MaxwellBlock::kSize);
  reserve(bergs_.size() * element::BergFriction::kMemorySize);
  placeAll(specimen_);
  placeAll(force_effects_);
  trial_size_ = memory_size_;
  placeAll(displacement_effects_);
  placeAll(rig_);
  behind_effects_slot_ = reserve(displacement_effects_.empty() ? 0 : 1);
  behind_mount_slot_ = reserve(mounted_ ? 1 : 0);
  plain_ = specimen_.empty() && force_effects_.empty() && displacement_effects_.empty() && rig_.empty() && !mounted_;
  frictionless_ = plain_ && bergs_.empty();
  mount_is_linear_ = joints_.empty() && mount_compliance_.tension == mount_compliance_.compression;
}

std::size_t Component::reserve(std::size_t size) {
  const std::size_t offset = memory_size_;
  memory_size_ += size;
  return offset;
}

ComponentState Component::makeState() const {
  ComponentState state;
  state.memory_.resize(memory_size_);
  state.scratch_.resize(mounted_ ? trial_size_ : 0);
  state.maxwell_blocks_.resize(maxwell_stiffness_.size() / kernel::MaxwellBlock::kSize);
  initialise(state, 0.0);
  return state;
}

element::ComponentForce Component::specimenRest(double displacement, bool as_new, double* memory) const {
  std::fill(memory, memory + maxwells_, 0.0);
  element::ComponentForce force;
  force.elastic = force.total = spring_stiffness_ * displacement;
  double* berg_memory = memory + maxwells_;
  for (const element::BergFriction& berg : bergs_) {
    add(force, element::Part::friction, berg.initialise(displacement, berg_memory));
    berg_memory += element::BergFriction::kMemorySize;
  }
  for (const auto& element : specimen_) {
    add(force, element.law->part(), element.law->initialise(displacement, memory + element.offset));
  }
  for (const auto& effect : force_effects_) {
    if (as_new) {
      effect.law->initialise(displacement, memory + effect.offset);
    } else {
      scale(force, effect.law->relax(displacement, memory + effect.offset));
    }
  }
  return force;
}

inline element::ComponentForce Component::plainStep(const ComponentState& state, const element::Motion& motion,
                                                    double* memory) const {
  const double viscous = viscousStep(state, motion.increment, memory);
  double friction = 0.0;
  double* berg_memory = memory + maxwells_;
  for (const element::BergFriction& berg : bergs_) {
    friction += berg.advance(motion.displacement, berg_memory);
    berg_memory += element::BergFriction::kMemorySize;
  }
  return sumOf(motion.displacement, viscous, friction);
}

void Component::specimenSteps(const ComponentState& state, const element::Motion* motion, std::size_t count,
                              double* memory, element::ComponentForce* force) const {
  for (std::size_t i = 0; i < count; ++i) {
    force[i] = plainStep(state, motion[i], memory);
  }
  for (const auto& element : specimen_) {
    addSteps(element, motion, count, memory, force);
  }
  for (const auto& effect : force_effects_) {
    for (std::size_t i = 0; i < count; ++i) {
      scale(force[i], effect.law->step(motion[i], force[i], memory + effect.offset));
    }
  }
}

void Component::addSteps(const Placed<element::ParallelElement>& element, const element::Motion* motion,
                         std::size_t count, double* memory, element::ComponentForce* force) {
  const element::Part part = element.law->part();
  for (std::size_t i = 0; i < count; ++i) {
    add(force[i], part, element.law->step(motion[i], memory + element.offset));
  }
}

// Compliance of mounts that are linear to either side, by the force without them: they take from it, never its sign.
inline double Component::complianceAt(double force) const {
  return force > 0.0 ? mount_compliance_.tension : mount_compliance_.compression;
}

inline double Component::mountDeflection(double force) const {
  double deflection = complianceAt(force) * force;
  for (const auto& joint : joints_) {
    deflection += joint->deflection(force);
  }
  return deflection;
}

double Component::behindMountAtRest(ComponentState& state, double displacement, bool as_new) const {
  return solveSeries(
      [&](double specimen) {
        std::copy_n(state.memory_.begin(), trial_size_, state.scratch_.begin());
        return specimen + mountDeflection(specimenRest(specimen, as_new, state.scratch_.data()).total) - displacement;
      },
      displacement);
}

// Force of friction at the end of a trial step [N], from the memory of all elements of that kind.
inline double Component::trialFriction(double specimen, const double* memory) const {
  double friction = 0.0;
  for (const element::BergFriction& berg : bergs_) {
    std::array<double, element::BergFriction::kMemorySize> trial;
    std::copy_n(memory, trial.size(), trial.begin());
    friction += berg.advance(specimen, trial.data());
    memory += trial.size();
  }
  return friction;
}

// Force of springs, dashpots, Maxwell elements and Berg friction at the end of a trial step [N]: what is linear in the
// displacement is summed up once, not for each trial.
inline Component::Line Component::lineOf(const ComponentState& state) const {
  double slope = state.dashpot_gain_;
  double held = 0.0;
  for (std::size_t i = 0; i < maxwells_; ++i) {
    const kernel::MaxwellBlock& block = state.maxwell_blocks_[i / kernel::MaxwellBlock::kSize];
    const std::size_t pair = i % kernel::MaxwellBlock::kSize / 2;
    slope += block.gain[pair][i % 2];
    held += block.decay[pair][i % 2] * state.memory_[i];
  }
  return {held - slope * state.memory_[behind_mount_slot_], slope + spring_stiffness_};
}

inline double Component::forceAt(double specimen, Line line, const double* berg_memory) const {
  return line.held + line.slope * specimen + trialFriction(specimen, berg_memory);
}

// Displacement of such a specimen behind a mount of this compliance.
inline double Component::solveSeriesBalance(Line line, double compliance, const ComponentState& state,
                                            const element::Motion& motion) const {
  const double slope = 1.0 + compliance * line.slope;
  const double rest = compliance * line.held - motion.displacement;
  const double* berg_memory = state.memory_.data() + maxwells_;
  if (bergs_.empty()) {
    return -rest / slope;
  }
  if (bergs_.size() == 1) {
    const double specimen = bergs_.front().solveSeriesBalance(slope, rest, compliance, berg_memory);
    if (bergs_.front().keepsDirection(specimen, berg_memory)) {
      return specimen;
    }
  }
  return solveSeries(
      [&](double specimen) { return slope * specimen + rest + compliance * trialFriction(specimen, berg_memory); },
      state.memory_[behind_mount_slot_] + motion.increment, slope);
}

double Component::plainBehindMount(const ComponentState& state, const element::Motion& motion) const {
  return solveSeriesBalance(lineOf(state), mount_compliance_.tension, state, motion);
}

double Component::plainBehindUnevenMount(const ComponentState& state, const element::Motion& motion) const {
  const Line line = lineOf(state);
  const double* berg_memory = state.memory_.data() + maxwells_;
  if (joints_.empty()) {
    return solveSeriesBalance(line, complianceAt(forceAt(motion.displacement, line, berg_memory)), state, motion);
  }
  return solveSeries(
      [&](double specimen) {
        return specimen + mountDeflection(forceAt(specimen, line, berg_memory)) - motion.displacement;
      },
      state.memory_[behind_mount_slot_] + motion.increment);
}

double Component::behindMount(ComponentState& state, const element::Motion& motion) const {
  if (specimen_.empty() && force_effects_.empty()) {
    return mount_is_linear_ ? plainBehindMount(state, motion) : plainBehindUnevenMount(state, motion);
  }
  const double before = state.memory_[behind_mount_slot_];
  return solveSeries(
      [&](double specimen) {
        std::copy_n(state.memory_.begin(), trial_size_, state.scratch_.begin());
        const element::Motion trial{motion.dt, specimen, specimen - before};
        element::ComponentForce force;
        specimenSteps(state, &trial, 1, state.scratch_.data(), &force);
        return specimen + mountDeflection(force.total) - motion.displacement;
      },
      before + motion.increment);
}

element::ComponentForce Component::settle(ComponentState& state, double displacement, bool as_new) const {
  double* memory = state.memory_.data();
  double specimen = displacement;
  for (const auto& effect : displacement_effects_) {
    specimen = effect.law->initialise(specimen, memory + effect.offset);
  }
  if (!displacement_effects_.empty()) {
    memory[behind_effects_slot_] = specimen;
  }
  if (mounted_) {
    specimen = behindMountAtRest(state, specimen, as_new);
    memory[behind_mount_slot_] = specimen;
  }
  element::ComponentForce force = specimenRest(specimen, as_new, memory);
  for (const auto& element : rig_) {
    add(force, element.law->part(), element.law->initialise(displacement, memory + element.offset));
  }
  state.displacement_ = displacement;
  state.branch_ = {};
  return force;
}

element::ComponentForce Component::initialise(ComponentState& state, double displacement) const {
  return settle(state, displacement, true);
}

element::ComponentForce Component::relax(ComponentState& state, double displacement) const {
  return settle(state, displacement, false);
}

element::ComponentForce Component::fullStep(ComponentState& state, double dt, double displacement) const {
  if (dt != state.prepared_dt_) {
    prepare(state, dt);
  }
  if (keepsDirection(state, displacement)) {
    return leanStep(state, displacement);
  }
  if (!plain_) {
    element::ComponentForce force;
    stepsThroughEffects(state, dt, &displacement, 1, &force);
    return force;
  }
  const double increment = displacement - state.displacement_;
  state.displacement_ = displacement;
  double* memory = state.memory_.data();
  if (bergs_.size() > 1) {
    return plainStep(state, {dt, displacement, increment}, memory);
  }
  const double friction = bergs_.front().advance(displacement, memory + maxwells_, state.branch_);
  return sumOf(displacement, viscousStep(state, increment, memory), friction);
}

// Increments of displacements [m], the one before the first being kept in `last`.
void Component::takeIncrements(element::Motion* motion, std::size_t count, double& last) {
  for (std::size_t i = 0; i < count; ++i) {
    motion[i].increment = motion[i].displacement - last;
    last = motion[i].displacement;
  }
}

void Component::stepsThroughEffects(ComponentState& state, double dt, const double* displacement, std::size_t count,
                                    element::ComponentForce* force) const {
  double* memory = state.memory_.data();
  std::array<element::Motion, kEffectBlock> actuator;
  std::array<element::Motion, kEffectBlock> specimen;
  for (std::size_t i = 0; i < count; ++i) {
    actuator[i] = {dt, displacement[i], 0.0};
  }
  takeIncrements(actuator.data(), count, state.displacement_);
  std::copy_n(actuator.begin(), count, specimen.begin());
  if (!displacement_effects_.empty()) {
    for (const auto& effect : displacement_effects_) {
      for (std::size_t i = 0; i < count; ++i) {
        specimen[i].displacement = effect.law->step(specimen[i], memory + effect.offset);
      }
    }
    takeIncrements(specimen.data(), count, memory[behind_effects_slot_]);
  }
  if (mounted_) {
    for (std::size_t i = 0; i < count; ++i) {
      specimen[i].displacement = behindMount(state, specimen[i]);
      takeIncrements(&specimen[i], 1, memory[behind_mount_slot_]);
      specimenSteps(state, &specimen[i], 1, memory, force + i);
    }
  } else {
    specimenSteps(state, specimen.data(), count, memory, force);
  }
  for (const auto& element : rig_) {
    addSteps(element, actuator.data(), count, memory, force);
  }
}

Tangent Component::tangent(const ComponentState& state, double dt, double displacement, ComponentState& trial) const {
  constexpr double kDistance = 1e-8;  // [m]
  trial = state;
  const element::ComponentForce above = step(trial, dt, displacement + kDistance);
  trial = state;
  const element::ComponentForce below = step(trial, dt, displacement - kDistance);
  const double distance = (displacement + kDistance) - (displacement - kDistance);
  const double retained = (above.elastic - below.elastic) + (above.friction - below.friction);
  return {retained / distance, dt * (above.viscous - below.viscous) / distance};
}

bool Component::linear() const { return complexStiffness(1.0).has_value(); }

std::optional<std::complex<double>> Component::specimenStiffness(double omega) const {
  if (!force_effects_.empty() || !bergs_.empty()) {
    return std::nullopt;
  }
  std::complex<double> sum(spring_stiffness_, omega * dashpot_damping_);
  for (std::size_t i = 0; i < maxwells_; ++i) {
    const std::complex<double> iwt(0.0, omega / maxwell_rate_[i]);
    sum += maxwell_stiffness_[i] * iwt / (1.0 + iwt);
  }
  for (const auto& element : specimen_) {
    const auto stiffness = element.law->complexStiffness(omega);
    if (!stiffness) {
      return std::nullopt;
    }
    sum += *stiffness;
  }
  return sum;
}

std::optional<std::complex<double>> Component::complexStiffness(double frequency) const {
  const double omega = 2.0 * M_PI * frequency;
  const auto specimen = specimenStiffness(omega);
  if (!specimen || !mount_is_linear_) {
    return std::nullopt;
  }
  std::complex<double> total = *specimen / (1.0 + mount_compliance_.tension * *specimen);
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

}  // namespace rubber_suspension::component
