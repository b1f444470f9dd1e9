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
    : data_(std::move(data)), table_(data_), log_(std::move(log)), fingerprint_(fingerprintOf(data_.guid)) {
  now_.parameters = table_.startValues();
}

Status Instance::error(const std::string& message) {
  log_(Status::error, category::kError, message);
  return Status::error;
}

Status Instance::discard(const std::string& message) {
  log_(Status::discard, category::kDiscard, message);
  return Status::discard;
}

Status Instance::refuseOrder(const std::string& what) {
  return error(fmt::format("{}: not in phase '{}'", what, nameOf(now_.phase)));
}

Status Instance::enter(Phase phase) {
  now_.phase = phase;
  if (log_events_) {
    log_(Status::ok, category::kEvents, fmt::format("phase '{}' at {:.9g} s", nameOf(phase), now_.time));
  }
  return Status::ok;
}

Status Instance::setTimes(double start, bool stop_defined, double stop) {
  if (now_.phase != Phase::instantiated) {
    return refuseOrder("set up of the experiment");
  }
  if (!std::isfinite(start) || (stop_defined && !(stop >= start))) {
    return error(fmt::format("start time {:g} s, stop time {:g} s; accepted: finite, the stop not before the start",
                             start, stop_defined ? stop : start));
  }
  now_.time = start;
  now_.stop_time = stop_defined ? std::min(stop, kNoStop) : kNoStop;
  return Status::ok;
}

Status Instance::enterInitialisation() {
  if (now_.phase != Phase::instantiated) {
    return refuseOrder("enter initialisation");
  }
  return enter(Phase::initialising);
}

Status Instance::exitInitialisation() {
  if (now_.phase != Phase::initialising) {
    return refuseOrder("exit initialisation");
  }
  settle();
  return enter(Phase::stepping);
}

Status Instance::terminate() {
  return now_.phase == Phase::stepping ? enter(Phase::terminated) : refuseOrder("terminate");
}

Status Instance::reset() {
  now_ = {};
  now_.parameters = table_.startValues();
  calculated_.clear();
  body_.reset();
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
  if (now_.phase > (parameter ? Phase::initialising : Phase::stepping)) {
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
    now_.parameters[reference - table_.firstParameter()] = value;
    body_.reset();
    now_.settled = false;
    return;
  }
  now_.settled = now_.settled && now_.phase == Phase::stepping;
  if (reference != table_.temperature()) {
    now_.inputs[reference - reference::kFirstInput] = value;
    return;
  }
  now_.temperature = value;
  if (now_.settled) {
    body_->setTemperature(now_.temperature);
  }
}

Status Instance::getAll(const Reference* references, std::size_t count, double* values) {
  if (count > 0 && (references == nullptr || values == nullptr)) {
    return error("get: a null pointer");
  }
  if (now_.phase == Phase::instantiated) {
    return refuseOrder("get");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (references[i] >= table_.variables().size()) {
      return error(fmt::format("get: no variable has the reference {}", references[i]));
    }
  }
  if (now_.phase == Phase::initialising) {
    settle();
  }
  std::transform(references, references + count, values, [this](Reference reference) { return value(reference); });
  return Status::ok;
}

double Instance::value(Reference reference) const {
  if (reference == reference::kTime) {
    return now_.time;
  }
  if (reference < table_.firstOutput()) {
    return now_.inputs[reference - reference::kFirstInput];
  }
  if (reference < table_.firstParameter()) {
    return now_.outputs[reference - table_.firstOutput()];
  }
  if (reference == table_.temperature()) {
    return now_.temperature ? *now_.temperature : table_.variables()[reference].start.value();
  }
  const std::size_t parameter = reference - table_.firstParameter();
  return parameter < now_.parameters.size() ? now_.parameters[parameter]
                                            : calculated_[parameter - now_.parameters.size()];
}

Status Instance::setDerivative(Reference reference, int order, double value) {
  if (now_.phase > Phase::stepping) {
    return refuseOrder("set of a derivative");
  }
  if (data_.six || reference != reference::kDisplacement || order < 1 || order > static_cast<int>(kMostDerivatives)) {
    return error(fmt::format("derivative {} of variable {}; accepted: the displacement, orders 1 to {}", order,
                             reference, kMostDerivatives));
  }
  if (!std::isfinite(value)) {
    return error(fmt::format("derivative {} of the displacement: {} is not finite", order, value));
  }
  now_.derivative[static_cast<std::size_t>(order - 1)] = value;
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
    body_ = build(now_.parameters, calculated);
    calculated_ = std::move(calculated);
  }
  if (!now_.settled) {
    body_->setTemperature(now_.temperature);
    now_.outputs = body_->initialise(now_.inputs);
    now_.settled = true;
  }
}

// Importers count time in sums of their own. The time of each step is taken from them, so one rounding of such a sum
// lies between theirs and ours, 1e-16 of the time; 1e-9 of it and a millionth of the step leave them ample room, and
// what is more is a step left out or done twice, or one beyond the stop time.
double Instance::roomFor(double size) const { return 1e-6 * size + 1e-9 * std::abs(now_.time); }

bool Instance::isInTime(double time, double size) const {
  return std::abs(time - now_.time) <= roomFor(size) && time + size <= now_.stop_time + roomFor(size);
}

// The displacement at the end of a step, which uses up the derivatives.
Numbers Instance::extrapolated(double size) {
  Numbers moved = now_.inputs;
  double power = 1.0;  // size^k/k!
  for (std::size_t k = 0; k < kMostDerivatives; ++k) {
    power *= size / static_cast<double>(k + 1);
    moved[0] += power * now_.derivative[k];
  }
  now_.derivative = {};
  has_derivatives_ = false;
  return moved;
}

Status Instance::stepInFull(double time, double size) {
  if (!body_->holds(now_.inputs)) {
    return error("step: a rotation beyond the end of its measure");
  }
  now_.time = time + size;
  return body_->step(size, extrapolated(size), now_.outputs) ? Status::ok : fail();
}

Status Instance::refuseStep(double time, double size) {
  if (now_.phase != Phase::stepping) {
    return refuseOrder("step");
  }
  if (!(size > 0.0) || !std::isfinite(size)) {
    return error(fmt::format("step of {:g} s; accepted: greater than 0", size));
  }
  if (std::abs(time - now_.time) <= roomFor(size)) {
    return error(
        fmt::format("step to {:.9g} s; accepted: to the stop time, {:.9g} s, at most", time + size, now_.stop_time));
  }
  return error(fmt::format("step from {:.9g} s; accepted: from {:.9g} s, where the last one ended", time, now_.time));
}

Status Instance::fail() {
  enter(Phase::failed);
  return error(fmt::format("{} gives a force that is not finite; a reset or a saved state is needed",
                           data_.six ? "the pose" : fmt::format("displacement {:g} m", now_.inputs[0])));
}

Status Instance::save(SavedState& state) {
  if (now_.phase == Phase::failed) {
    return refuseOrder("save of the state");
  }
  state.fingerprint = fingerprint_;
  state.standing = now_;
  state.memory.clear();
  if (now_.settled) {
    body_->save(state);
  }
  return Status::ok;
}

Status Instance::restore(const SavedState& state) {
  const Standing& saved = state.standing;
  if (state.fingerprint != fingerprint_ || saved.parameters.size() != now_.parameters.size()) {
    return error("restore of a state: it is not one of this FMU");
  }
  if (saved.phase == Phase::failed || (saved.phase > Phase::initialising && !saved.settled)) {
    return error("restore of a state: it is not one to continue from");
  }
  // All that can fail comes first: an instance is changed as a whole or not at all.
  if (body_ && saved.parameters == now_.parameters) {
    if (saved.settled) {
      body_->restore(state);
    }
  } else {
    std::vector<double> calculated;
    std::optional<Body> rebuilt;
    if (saved.settled) {
      rebuilt = build(saved.parameters, calculated);
      rebuilt->restore(state);
    }
    body_ = std::move(rebuilt);
    calculated_ = std::move(calculated);
  }
  now_ = saved;
  has_derivatives_ =
      std::any_of(now_.derivative.begin(), now_.derivative.end(), [](double value) { return value != 0.0; });
  return Status::ok;
}

}  // namespace rubber_suspension::fmi
