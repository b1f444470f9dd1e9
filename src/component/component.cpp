// A component's signal path from displacement to force.
#include "rubber_suspension/component/component.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "component/equal_run.h"
#include "component/series_root.h"
#include "kernel/softening_bank.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::component {
namespace {

constexpr std::size_t kPathBlock = 64;  // most steps that are computed together, law after law

// Number of steps for code that computes single steps: a constant for the compiler.
using One = std::integral_constant<std::size_t, 1>;
template <class Number, class Count>
using Block = std::array<Number, std::is_same_v<Count, One> ? 1 : kPathBlock>;

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

// Applies one step of the effects that scale a force.
template <class Effects>
void scaleBy(const Effects& effects, const element::Motion& motion, double* memory, element::ComponentForce& force) {
  for (const auto& effect : effects) {
    scale(force, effect.law->step(motion, force, memory + effect.offset));
  }
}

// Adds the forces of an element to those of other elements.
template <class Count>
void addSteps(const element::ParallelElement& law, const element::Motion* motion, Count count, double* memory,
              element::ComponentForce* force) {
  const element::Part part = law.part();
  for (std::size_t i = 0; i < count; ++i) {
    add(force[i], part, law.step(motion[i], memory));
  }
}

// Returns the sum of the forces of several laws at the end of one step.
template <class Laws>
element::ComponentForce stepOf(Laws first, Laws last, const element::Motion& motion, double* memory) {
  element::ComponentForce sum;
  for (; first != last; ++first) {
    add(sum, first->law->part(), first->law->step(motion, memory + first->offset));
  }
  return sum;
}

// Returns the force of linear laws per metre of a step of dt [s].
template <class Laws>
element::ComponentForce slopeOf(Laws first, Laws last, double dt, double* memory) {
  element::ComponentForce sum;
  for (; first != last; ++first) {
    double* own = memory + first->offset;
    const double at_rest = first->law->initialise(0.0, own);
    add(sum, first->law->part(), first->law->step({dt, 1.0, 1.0}, own) - at_rest);
  }
  return sum;
}

void addTimes(double factor, const element::ComponentForce& more, element::ComponentForce& sum) {
  sum.total += factor * more.total;
  sum.elastic += factor * more.elastic;
  sum.viscous += factor * more.viscous;
  sum.friction += factor * more.friction;
}

// A value below absolute zero, which means that no temperature is known.
constexpr double kUnknownTemperature = -1e3;  // [degC]

// Sets the increments of displacements [m]. `last` is the displacement before the first one and is updated.
template <class Count>
void takeIncrements(element::Motion* motion, Count count, double& last) {
  for (std::size_t i = 0; i < count; ++i) {
    motion[i].increment = motion[i].displacement - last;
    last = motion[i].displacement;
  }
}

}  // namespace

Component::Component(const std::vector<element::ElementDescription>& elements) {
  element::BasicLaws basic_laws;
  std::shared_ptr<kernel::SofteningBank> bank;  // collects laws that follow each other
  for (const element::ElementDescription& description : elements) {
    descriptions_.push_back(element::complete(description));
    const element::ElementPointer element = element::makeElement(description);
    if (const auto* effect = std::get_if<std::shared_ptr<const element::DisplacementEffect>>(&element)) {
      displacement_effects_.push_back({*effect, 0});
    } else if (const auto* factor = std::get_if<std::shared_ptr<const element::ForceEffect>>(&element)) {
      const bool joins = kernel::SofteningBank::takes(descriptions_.back());
      if (!joins || !bank) {
        bank = joins ? std::make_shared<kernel::SofteningBank>() : nullptr;
        force_effects_.push_back({joins ? bank : *factor, 0});
      }
      if (joins) {
        bank->add(descriptions_.back(), *factor);
      }
    } else if (const auto* compliance = std::get_if<std::shared_ptr<const element::SeriesElement>>(&element)) {
      series_.add(*compliance);
    } else if (const auto* shift = std::get_if<std::shared_ptr<const element::TemperatureShift>>(&element)) {
      shifts_.push_back(*shift);
      temperatures_ = element::intersection(temperatures_, (*shift)->temperatures());
    } else {
      place(std::get<std::shared_ptr<const element::ParallelElement>>(element), basic_laws);
    }
  }
  std::stable_partition(displacement_effects_.begin(), displacement_effects_.end(),
                        [](const auto& effect) { return effect.law->ofSensor(); });
  kernel_ = kernel::BasicLawsKernel(basic_laws);
  reserveMemory();
}

void Component::place(const std::shared_ptr<const element::ParallelElement>& law, element::BasicLaws& basic_laws) {
  if (law->onRig()) {
    rig_.push_back({law, 0});
  } else if (!law->addTo(basic_laws)) {
    elements_.push_back({law, 0});
  }
}

template <class Law>
void Component::placeMemory(std::vector<Placed<Law>>& placed) {
  for (Placed<Law>& element : placed) {
    element.offset = reserve(element.law->memorySize());
  }
}

std::size_t Component::reserve(std::size_t size) {
  const std::size_t offset = memory_size_;
  memory_size_ += size;
  return offset;
}

void Component::reserveMemory() {
  reserve(kernel_.memorySize());
  placeMemory(elements_);
  linear_count_ = std::stable_partition(elements_.begin(), elements_.end(),
                                        [](const auto& element) { return element.law->linear(); }) -
                  elements_.begin();
  placeMemory(force_effects_);
  temperature_slot_ = reserve(shifts_.empty() ? 0 : kTemperatureSlots);
  trial_size_ = memory_size_;
  placeMemory(displacement_effects_);
  placeMemory(rig_);
  behind_effects_slot_ = reserve(displacement_effects_.empty() ? 0 : 1);
  test_piece_slot_ = reserve(series_.empty() ? 0 : 1);
  kernel_alone_ = displacement_effects_.empty() && series_.empty() && elements_.empty() && force_effects_.empty() &&
                  rig_.empty() && shifts_.empty();
}

ComponentState Component::makeState() const {
  ComponentState state;
  state.memory_.resize(memory_size_);
  state.trial_.memory.resize(series_.empty() ? 0 : trial_size_);
  state.prepared_ = kernel_.makePreparedStep();
  state.kernel_alone_ = kernel_alone_;
  forgetTemperature(state);
  initialise(state, 0.0);
  return state;
}

void Component::restore(ComponentState& state, double displacement, const std::vector<double>& memory) const {
  if (memory.size() != memory_size_) {
    throw std::invalid_argument(
        fmt::format("the state has {} numbers, but this component needs {}", memory.size(), memory_size_));
  }
  const bool finite = std::isfinite(displacement) &&
                      std::all_of(memory.begin(), memory.end(), [](double value) { return std::isfinite(value); });
  if (!finite) {
    throw std::invalid_argument("the state contains numbers that are not finite");
  }
  if (!acceptsMemory(memory.data())) {
    throw std::invalid_argument("the state contains numbers that the elements of this component cannot reach");
  }
  state.displacement_ = displacement;
  std::copy(memory.begin(), memory.end(), state.memory_.begin());
  state.prepared_.branch = {};
}

// The factors of a temperature have to be greater than 0, so that time and force keep their signs.
bool Component::acceptsMemory(const double* memory) const {
  const auto all = [memory](const auto& placed) {
    return std::all_of(placed.begin(), placed.end(),
                       [memory](const auto& element) { return element.law->acceptsMemory(memory + element.offset); });
  };
  const double* const slots = memory + temperature_slot_;
  return all(elements_) && all(force_effects_) && all(displacement_effects_) && all(rig_) &&
         (shifts_.empty() || (slots[kRate] > 0.0 && slots[kForce] > 0.0));
}

element::ComponentForce Component::initialise(ComponentState& state, double displacement) const {
  return start(state, displacement, Start::as_new);
}

element::ComponentForce Component::relax(ComponentState& state, double displacement) const {
  return start(state, displacement, Start::relaxed);
}

element::ComponentForce Component::start(ComponentState& state, double displacement, Start kind) const {
  double* memory = state.memory_.data();
  double test_piece = displacement;
  for (const auto& effect : displacement_effects_) {
    test_piece = effect.law->initialise(test_piece, memory + effect.offset);
  }
  if (!displacement_effects_.empty()) {
    memory[behind_effects_slot_] = test_piece;
  }
  if (!series_.empty()) {
    test_piece = balanceAtStart(state, test_piece, kind);
    memory[test_piece_slot_] = test_piece;
  }
  element::ComponentForce force = startTestPiece(test_piece, kind, memory);
  for (const auto& element : rig_) {
    add(force, element.law->part(), element.law->initialise(displacement, memory + element.offset));
  }
  state.displacement_ = displacement;
  state.prepared_.branch = {};
  return force;
}

element::ComponentForce Component::startTestPiece(double displacement, Start kind, double* memory) const {
  element::ComponentForce force = kernel_.initialise(displacement, memory);
  for (const auto& element : elements_) {
    double* own = memory + element.offset;
    add(force, element.law->part(),
        kind == Start::as_new ? element.law->initialise(displacement, own) : element.law->relax(displacement, own));
  }
  if (!shifts_.empty()) {
    scale(force, memory[temperature_slot_ + kForce]);
  }
  for (const auto& effect : force_effects_) {
    if (kind == Start::as_new) {
      effect.law->initialise(displacement, memory + effect.offset);
      scale(force, effect.law->constantFactor().value_or(1.0));
    } else {
      scale(force, effect.law->relax(displacement, memory + effect.offset));
    }
  }
  return force;
}

// Returns the displacement of a test piece with the law `force`. `before`: displacement at the beginning of the step.
template <class Force>
double Component::solveSeries(Force force, double path, double before, double guess) const {
  const double closed = solveSeriesBalance([&](double z) { return z + series_.deflection(force(z)) - path; }, guess);
  if (!series_.hasContact()) {
    return closed;
  }
  const double there = force(closed);
  if (!series_.opensUnder(there)) {
    return closed;
  }
  const double kept = series_.keptBy(there);
  return solveFreeLength([&](double z) { return force(z) - kept; }, closed, there - kept, before);
}

double Component::balanceAtStart(ComponentState& state, double displacement, Start kind) const {
  return solveSeries(
      [&](double test_piece) {
        std::copy_n(state.memory_.begin(), trial_size_, state.trial_.memory.begin());
        return startTestPiece(test_piece, kind, state.trial_.memory.data()).total;
      },
      displacement, 0.0, displacement);
}

void Component::simulate(ComponentState& state, double dt, const double* displacement, std::size_t count,
                         double* force) const {
  if (count == 0) {
    return;
  }
  if (kernel_alone_) {
    kernel_.simulate(dt, state.displacement_, displacement, count, force, state.memory_.data(), state.prepared_);
    state.displacement_ = displacement[count - 1];
    return;
  }
  std::array<element::ComponentForce, kPathBlock> forces;
  for (std::size_t first = 0; first < count; first += kPathBlock) {
    const std::size_t size = std::min(kPathBlock, count - first);
    stepsAlongPath(state, dt, displacement + first, size, forces.data());
    std::transform(forces.begin(), forces.begin() + static_cast<std::ptrdiff_t>(size), force + first,
                   [](const element::ComponentForce& parts) { return parts.total; });
  }
}

void Component::simulate(ComponentState& state, double dt, const double* displacement, const double* temperature,
                         std::size_t count, double* force) const {
  for (std::size_t first = 0; first < count;) {
    const std::size_t size = equalRun(temperature + first, count - first);
    setTemperature(state, temperature[first]);
    simulate(state, dt, displacement + first, size, force + first);
    first += size;
  }
}

element::Shift Component::shiftAt(double temperature) const {
  if (!shifts_.empty() && !temperatures_.contains(temperature)) {
    throw std::invalid_argument(
        fmt::format("temperature: {:g} degC is out of range; accepted: {} degC", temperature, describe(temperatures_)));
  }
  element::Shift sum;
  for (const auto& law : shifts_) {
    const element::Shift shift = law->at(temperature);
    sum.time *= shift.time;
    sum.force *= shift.force;
  }
  return sum;
}

void Component::setTemperature(ComponentState& state, double temperature) const {
  if (shifts_.empty() || temperature == state.memory_[temperature_slot_ + kTemperature]) {
    return;
  }
  const element::Shift shift = shiftAt(temperature);
  double* const slots = state.memory_.data() + temperature_slot_;
  slots[kTemperature] = temperature;
  slots[kRate] = 1.0 / shift.time;
  slots[kForce] = shift.force;
}

void Component::forgetTemperature(ComponentState& state) const {
  if (shifts_.empty()) {
    return;
  }
  double* const slots = state.memory_.data() + temperature_slot_;
  slots[kTemperature] = kUnknownTemperature;
  slots[kRate] = slots[kForce] = 1.0;
}

element::ComponentForce Component::stepAlongPath(ComponentState& state, double dt, double displacement) const {
  element::ComponentForce force;
  stepsAlongPath(state, dt, &displacement, One(), &force);
  return force;
}

template <class Count>
void Component::stepsAlongPath(ComponentState& state, double dt, const double* displacement, Count count,
                               element::ComponentForce* force) const {
  double* memory = state.memory_.data();
  if (const double reduced = reducedStep(dt, memory); reduced != state.prepared_.dt) {
    kernel_.prepare(reduced, state.prepared_);
  }
  Block<element::Motion, Count> actuator;
  Block<element::Motion, Count> test_piece;
  for (std::size_t i = 0; i < count; ++i) {
    actuator[i] = {dt, displacement[i], 0.0};
  }
  takeIncrements(actuator.data(), count, state.displacement_);
  std::copy_n(actuator.begin(), count, test_piece.begin());
  applyDisplacementEffects(test_piece.data(), count, memory);
  if (series_.empty()) {
    stepTestPiece(state.prepared_, test_piece.data(), count, memory, force);
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      test_piece[i].displacement = balance(state, test_piece[i]);
      takeIncrements(&test_piece[i], One(), memory[test_piece_slot_]);
      if (test_piece[i].displacement != state.trial_.displacement) {
        stepTestPiece(state.prepared_, &test_piece[i], One(), memory, force + i);
        continue;
      }
      // The last trial was this step, except that it did not advance the memory of the linear laws.
      const element::Motion reduced{state.prepared_.dt, test_piece[i].displacement, test_piece[i].increment};
      stepOf(elements_.begin(), elements_.begin() + linear_count_, reduced, state.trial_.memory.data());
      std::copy_n(state.trial_.memory.begin(), trial_size_, memory);
      force[i] = state.trial_.force;
    }
  }
  for (const auto& element : rig_) {
    addSteps(*element.law, actuator.data(), count, memory + element.offset, force);
  }
}

template <class Count>
void Component::applyDisplacementEffects(element::Motion* motion, Count count, double* memory) const {
  if (displacement_effects_.empty()) {
    return;
  }
  for (const auto& effect : displacement_effects_) {
    for (std::size_t i = 0; i < count; ++i) {
      motion[i].displacement = effect.law->step(motion[i], memory + effect.offset);
    }
  }
  takeIncrements(motion, count, memory[behind_effects_slot_]);
}

// Returns the displacement of the test piece behind the elements in series.
double Component::balance(ComponentState& state, const element::Motion& path) const {
  const double before = state.memory_[test_piece_slot_];
  if (elements_.empty() && force_effects_.empty() && shifts_.empty() && !series_.hasContact()) {
    return series_.solve(kernel_, path, before, state.memory_.data(), state.prepared_);
  }
  const double* const memory = state.memory_.data();
  ComponentState::Trial& tried = state.trial_;
  double* const trial = tried.memory.data();
  const double dt = state.prepared_.dt;
  const auto nonlinear = elements_.begin() + linear_count_;
  if (tried.slope_step != dt) {
    tried.slope_step = dt;
    tried.slope = slopeOf(elements_.begin(), nonlinear, dt, trial);
  }
  std::copy_n(memory, trial_size_, trial);
  const element::ComponentForce held = stepOf(elements_.begin(), nonlinear, {dt, before, 0.0}, trial);
  return solveSeries(
      [&](double z) {
        std::copy_n(memory, trial_size_, trial);
        const element::Motion reduced{dt, z, z - before};
        element::ComponentForce force = kernel_.stepWithoutBranch(reduced, trial, state.prepared_);
        addTimes(1.0, held, force);
        addTimes(reduced.increment, tried.slope, force);
        addTimes(1.0, stepOf(nonlinear, elements_.end(), reduced, trial), force);
        if (!shifts_.empty()) {
          scale(force, memory[temperature_slot_ + kForce]);
        }
        scaleBy(force_effects_, {path.dt, z, reduced.increment}, trial, force);
        tried.displacement = z;
        tried.force = force;
        return force.total;
      },
      path.displacement, before, series_.hasContact() ? path.displacement : before + path.increment);
}

// Sums up the forces of all elements in parallel.
template <class Count>
void Component::stepElements(const kernel::PreparedStep& prepared, const element::Motion* motion, Count count,
                             double* memory, element::ComponentForce* force) const {
  for (std::size_t i = 0; i < count; ++i) {
    force[i] = kernel_.stepWithoutBranch(motion[i], memory, prepared);
  }
  for (const auto& element : elements_) {
    addSteps(*element.law, motion, count, memory + element.offset, force);
  }
}

// Sums up all elements, in reduced time and times b_T if there is a shift with temperature, and applies force effects.
template <class Count>
void Component::stepTestPiece(const kernel::PreparedStep& prepared, const element::Motion* motion, Count count,
                              double* memory, element::ComponentForce* force) const {
  if (shifts_.empty()) {
    stepElements(prepared, motion, count, memory, force);
  } else {
    Block<element::Motion, Count> reduced{};
    for (std::size_t i = 0; i < count; ++i) {
      reduced[i] = {reducedStep(motion[i].dt, memory), motion[i].displacement, motion[i].increment};
    }
    stepElements(prepared, reduced.data(), count, memory, force);
    for (std::size_t i = 0; i < count; ++i) {
      scale(force[i], memory[temperature_slot_ + kForce]);
    }
  }
  for (const auto& effect : force_effects_) {
    for (std::size_t i = 0; i < count; ++i) {
      scale(force[i], effect.law->step(motion[i], force[i], memory + effect.offset));
    }
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

std::optional<std::complex<double>> Component::testPieceStiffness(double omega) const {
  std::optional<std::complex<double>> sum = kernel_.complexStiffness(omega);
  if (!sum) {
    return std::nullopt;
  }
  for (const auto& element : elements_) {
    const auto stiffness = element.law->complexStiffness(omega);
    if (!stiffness) {
      return std::nullopt;
    }
    *sum += *stiffness;
  }
  for (const auto& effect : force_effects_) {
    const std::optional<double> factor = effect.law->constantFactor();
    if (!factor) {
      return std::nullopt;
    }
    *sum *= *factor;
  }
  return sum;
}

std::optional<std::complex<double>> Component::complexStiffnessShifted(double frequency,
                                                                       const element::Shift& shift) const {
  const double omega = 2.0 * element::kPi * frequency;
  const auto reduced = testPieceStiffness(shift.time * omega);
  if (!reduced || !series_.linear()) {
    return std::nullopt;
  }
  const std::complex<double> test_piece = shift.force * *reduced;
  std::complex<double> total = test_piece / (1.0 + series_.compliance() * test_piece);
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
