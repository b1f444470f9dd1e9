// One instance of an FMU: everything but the steps themselves.
#include "fmi/runtime/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rubber_suspension::fmi {
namespace {

const char* nameOf(Phase phase) {
  static const char* const names[] = {"instantiated", "initialisation", "stepping", "terminated", "failed"};
  return names[static_cast<std::size_t>(phase)];
}

}  // namespace

Instance::Instance(ComponentData data, Log log)
    : data_(std::move(data)),
      table_(data_),
      log_(std::move(log)),
      fingerprint_(fingerprintOf(data_.guid)),
      parameters_(table_.startValues()) {}

Status Instance::error(const std::string& message) {
  log_(Status::error, category::kError, message);
  return Status::error;
}

Status Instance::discard(const std::string& message) {
  log_(Status::discard, category::kDiscard, message);
  return Status::discard;
}

Status Instance::refuseOrder(const std::string& what) {
  return error(fmt::format("{}: not in phase '{}'", what, nameOf(phase_)));
}

Status Instance::enter(Phase phase) {
  phase_ = phase;
  if (log_events_) {
    log_(Status::ok, category::kEvents, fmt::format("phase '{}' at {:.9g} s", nameOf(phase), time_));
  }
  return Status::ok;
}

Status Instance::setTimes(double start, bool stop_defined, double stop) {
  if (phase_ != Phase::instantiated) {
    return refuseOrder("set up of the experiment");
  }
  if (!std::isfinite(start) || (stop_defined && !(stop >= start))) {
    return error(fmt::format("start time {:g} s, stop time {:g} s; accepted: finite, the stop not before the start",
                             start, stop_defined ? stop : start));
  }
  start_time_ = start;
  stop_time_ = stop_defined ? std::min(stop, kNoStop) : kNoStop;
  return Status::ok;
}

Status Instance::enterInitialisation() {
  if (phase_ != Phase::instantiated) {
    return refuseOrder("enter initialisation");
  }
  time_ = start_time_;
  return enter(Phase::initialising);
}

Status Instance::exitInitialisation() {
  if (phase_ != Phase::initialising) {
    return refuseOrder("exit initialisation");
  }
  settle();
  return enter(Phase::stepping);
}

Status Instance::terminate() { return phase_ == Phase::stepping ? enter(Phase::terminated) : refuseOrder("terminate"); }

Status Instance::reset() {
  parameters_ = table_.startValues();
  calculated_.clear();
  body_.reset();
  initialised_ = false;
  start_time_ = time_ = 0.0;
  stop_time_ = kNoStop;
  inputs_ = outputs_ = {};
  temperature_.reset();
  derivative_ = {};
  has_derivatives_ = false;
  return enter(Phase::instantiated);
}

Status Instance::setAll(const Reference* references, std::size_t count, const double* values) {
  if (count > 0 && (references == nullptr || values == nullptr)) {
    return error("set: a null pointer");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (const Status status = checkSet(references[i], values[i]); status != Status::ok) {
      return status;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    assign(references[i], values[i]);
  }
  return Status::ok;
}

Status Instance::checkSet(Reference reference, double value) {
  if (reference >= table_.variables().size()) {
    return error(fmt::format("set: no variable has the reference {}", reference));
  }
  const Variable& variable = table_.variables()[reference];
  const bool parameter = variable.causality == Causality::parameter;
  if (phase_ > (parameter ? Phase::initialising : Phase::stepping)) {
    return refuseOrder("set of " + variable.name);
  }
  if (!parameter && variable.causality != Causality::input) {
    return error(fmt::format("set: {} cannot be set", variable.name));
  }
  // Until the component is built, the range of the temperature is that of the parameters at the start.
  const bool shifted = reference == table_.temperature() && body_;
  const element::Range range = shifted ? body_->temperatures() : variable.range;
  if (std::isfinite(value) && range.contains(value)) {
    return Status::ok;
  }
  return discard(fmt::format("set: {}: {:g}{} is out of range; accepted: {}", variable.name, value,
                             variable.unit == "1" ? "" : " " + variable.unit, element::describe(range)));
}

void Instance::assign(Reference reference, double value) {
  if (table_.variables()[reference].causality == Causality::parameter) {
    parameters_[reference - table_.firstParameter()] = value;
    body_.reset();
    initialised_ = false;
    return;
  }
  initialised_ = initialised_ && phase_ == Phase::stepping;
  if (reference != table_.temperature()) {
    inputs_[reference - reference::kFirstInput] = value;
    return;
  }
  temperature_ = value;
  if (initialised_) {
    body_->setTemperature(temperature_);
  }
}

Status Instance::getAll(const Reference* references, std::size_t count, double* values) {
  if (count > 0 && (references == nullptr || values == nullptr)) {
    return error("get: a null pointer");
  }
  if (phase_ == Phase::instantiated) {
    return refuseOrder("get");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (references[i] >= table_.variables().size()) {
      return error(fmt::format("get: no variable has the reference {}", references[i]));
    }
  }
  if (phase_ == Phase::initialising) {
    settle();
  }
  std::transform(references, references + count, values, [this](Reference reference) { return value(reference); });
  return Status::ok;
}

double Instance::value(Reference reference) const {
  if (reference == reference::kTime) {
    return time_;
  }
  if (reference < table_.firstOutput()) {
    return inputs_[reference - reference::kFirstInput];
  }
  if (reference < table_.firstParameter()) {
    return outputs_[reference - table_.firstOutput()];
  }
  if (reference == table_.temperature()) {
    return temperature_ ? *temperature_ : table_.variables()[reference].start.value();
  }
  const std::size_t parameter = reference - table_.firstParameter();
  return parameter < parameters_.size() ? parameters_[parameter] : calculated_[parameter - parameters_.size()];
}

Status Instance::setDerivative(Reference reference, int order, double value) {
  if (phase_ > Phase::stepping) {
    return refuseOrder("set of a derivative");
  }
  if (data_.six || reference != reference::kDisplacement || order < 1 || order > static_cast<int>(kMostDerivatives)) {
    return error(fmt::format("derivative {} of variable {}; accepted: the displacement, orders 1 to {}", order,
                             reference, kMostDerivatives));
  }
  if (!std::isfinite(value)) {
    return error(fmt::format("derivative {} of the displacement: {} is not finite", order, value));
  }
  derivative_[static_cast<std::size_t>(order - 1)] = value;
  has_derivatives_ = true;
  return Status::ok;
}

// Throws where there is no component with these parameters.
Body Instance::build(const std::vector<double>& parameters, std::vector<double>& calculated) const {
  ComponentData changed = data_;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    setValue(changed, table_.place(i), parameters[i]);
  }
  calculated = table_.calculatedValues(changed.modelElements());
  return Body(changed);
}

void Instance::settle() {
  if (!body_) {
    std::vector<double> calculated;
    body_ = build(parameters_, calculated);
    calculated_ = std::move(calculated);
  }
  if (!initialised_) {
    body_->setTemperature(temperature_);
    outputs_ = body_->initialise(inputs_);
    initialised_ = true;
  }
}

// Importers count time in sums of their own. The time of each step is taken from them, so one rounding of such a sum
// lies between theirs and ours, 1e-16 of the time; 1e-9 of it and a millionth of the step leave them ample room, and
// what is more is a step left out or done twice, or one beyond the stop time.
double Instance::roomFor(double size) const { return 1e-6 * size + 1e-9 * std::abs(time_); }

bool Instance::isInTime(double time, double size) const {
  return std::abs(time - time_) <= roomFor(size) && time + size <= stop_time_ + roomFor(size);
}

// The displacement at the end of a step, which uses up the derivatives.
Numbers Instance::extrapolated(double size) {
  Numbers moved = inputs_;
  double power = 1.0;  // size^k/k!
  for (std::size_t k = 0; k < kMostDerivatives; ++k) {
    power *= size / static_cast<double>(k + 1);
    moved[0] += power * derivative_[k];
  }
  derivative_ = {};
  has_derivatives_ = false;
  return moved;
}

Status Instance::stepInFull(double time, double size) {
  if (!body_->holds(inputs_)) {
    return error("step: a rotation beyond the end of its measure");
  }
  time_ = time + size;
  return body_->step(size, extrapolated(size), outputs_) ? Status::ok : fail();
}

Status Instance::refuseStep(double time, double size) {
  if (phase_ != Phase::stepping) {
    return refuseOrder("step");
  }
  if (!(size > 0.0) || !std::isfinite(size)) {
    return error(fmt::format("step of {:g} s; accepted: greater than 0", size));
  }
  if (std::abs(time - time_) <= roomFor(size)) {
    return error(
        fmt::format("step to {:.9g} s; accepted: to the stop time, {:.9g} s, at most", time + size, stop_time_));
  }
  return error(fmt::format("step from {:.9g} s; accepted: from {:.9g} s, where the last one ended", time, time_));
}

Status Instance::fail() {
  enter(Phase::failed);
  return error(fmt::format("{} gives a force that is not finite; a reset or a saved state is needed",
                           data_.six ? "the pose" : fmt::format("displacement {:g} m", inputs_[0])));
}

Status Instance::save(SavedState& state) {
  if (phase_ == Phase::failed) {
    return refuseOrder("save of the state");
  }
  state.fingerprint = fingerprint_;
  state.phase = phase_;
  state.time = phase_ == Phase::instantiated ? start_time_ : time_;
  state.stop_time = stop_time_;
  state.inputs = inputs_;
  state.outputs = outputs_;
  state.temperature = temperature_;
  state.derivative = derivative_;
  state.parameters = parameters_;
  state.settled = body_ && initialised_;
  state.memory.clear();
  if (state.settled) {
    body_->save(state);
  }
  return Status::ok;
}

Status Instance::restore(const SavedState& state) {
  if (state.fingerprint != fingerprint_ || state.parameters.size() != parameters_.size()) {
    return error("restore of a state: it is not one of this FMU");
  }
  if (state.phase == Phase::failed || (state.phase > Phase::initialising && !state.settled)) {
    return error("restore of a state: it is not one to continue from");
  }
  // All that can fail comes first: an instance is changed as a whole or not at all.
  if (body_ && state.parameters == parameters_) {
    if (state.settled) {
      body_->restore(state);
    }
  } else {
    std::vector<double> calculated;
    std::optional<Body> rebuilt;
    if (state.settled) {
      rebuilt = build(state.parameters, calculated);
      rebuilt->restore(state);
    }
    body_ = std::move(rebuilt);
    calculated_ = std::move(calculated);
  }
  parameters_ = state.parameters;
  initialised_ = state.settled;
  time_ = state.time;
  stop_time_ = state.stop_time;
  start_time_ = state.phase == Phase::instantiated ? state.time : start_time_;
  inputs_ = state.inputs;
  outputs_ = state.outputs;
  temperature_ = state.temperature;
  derivative_ = state.derivative;
  has_derivatives_ = std::any_of(derivative_.begin(), derivative_.end(), [](double value) { return value != 0.0; });
  phase_ = state.phase;
  return Status::ok;
}

}  // namespace rubber_suspension::fmi
