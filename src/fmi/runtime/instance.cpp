// One instance of an FMU, except for the steps, which are in the header.
#include "fmi/runtime/instance.h"

#include <algorithm>
#include <utility>

#include "element/largest_number.h"
#include "element/refuse.h"

namespace rubber_suspension::fmi {

using element::refuseIf;

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

Status Instance::tell(Status status, const std::string& message) const {
  log_(status, message);
  return status;
}

void Instance::require(bool in_phase, const char* call) const {
  refuseIf(!in_phase, "{}: not allowed in phase '{}'", call, nameOf(now_.phase));
}

void Instance::enter(Phase phase) {
  now_.phase = phase;
  if (log_events_) {
    tell(Status::ok, fmt::format("phase '{}' at {:.9g} s", nameOf(phase), now_.time));
  }
}

void Instance::setTimes(double start, bool stop_defined, double stop) {
  require(now_.phase == Phase::instantiated, "set up of the experiment");
  refuseIf(!std::isfinite(start) || (stop_defined && !(stop >= start)),
           "start time {:g} s and stop time {:g} s are not possible; accepted: finite times, the stop time not before "
           "the start time",
           start, stop_defined ? stop : start);
  now_.time = start;
  now_.stop_time = stop_defined ? std::min(stop, kNoStop) : kNoStop;
}

void Instance::pass(Phase from, Phase to, const char* call) {
  require(now_.phase == from, call);
  if (to == Phase::stepping) {
    settle();
  }
  enter(to);
}

void Instance::reset() {
  now_ = {};
  now_.parameters = table_.startValues();
  body_.reset();
  has_derivatives_ = false;
  enter(Phase::instantiated);
}

void Instance::setAll(const Reference* references, std::size_t count, const double* values) {
  refuseIf(count > 0 && (references == nullptr || values == nullptr), "set: a pointer is null");
  for (std::size_t i = 0; i < count; ++i) {
    checkSet(references[i], values[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    assign(references[i], values[i]);
  }
}

void Instance::checkSet(Reference reference, double value) const {
  refuseIf(reference >= table_.variables().size(), "set: no variable has the value reference {}", reference);
  const Variable& variable = table_.variables()[reference];
  const bool parameter = variable.causality == Causality::parameter;
  refuseIf(now_.phase > (parameter ? Phase::initialising : Phase::stepping), "set of {}: not allowed in phase '{}'",
           variable.name, nameOf(now_.phase));
  refuseIf(!parameter && variable.causality != Causality::input, "set: {} cannot be set", variable.name);
  // Until the component is built, the range of the temperature belongs to the start values of the parameters.
  const bool shifted = reference == table_.temperature() && body_;
  const element::Range range = shifted ? body_->temperatures() : variable.range;
  if (!range.contains(value)) {
    throw Discarded(fmt::format("set: {}: {:g}{} is out of range; accepted: {}", variable.name, value,
                                variable.unit == "1" ? "" : " " + variable.unit, element::acceptedFor(value, range)));
  }
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
    now_.inputs[reference - reference::kDisplacement] = value;
    return;
  }
  now_.has_temperature = true;
  now_.degrees = value;
  if (now_.settled) {
    body_->setTemperature(value);
  }
}

void Instance::getAll(const Reference* references, std::size_t count, double* values) {
  refuseIf(count > 0 && (references == nullptr || values == nullptr), "get: a pointer is null");
  require(now_.phase != Phase::instantiated && now_.phase != Phase::failed, "get");
  for (std::size_t i = 0; i < count; ++i) {
    refuseIf(references[i] >= table_.variables().size(), "get: no variable has the value reference {}", references[i]);
  }
  if (now_.phase == Phase::initialising) {
    settle();
  }
  std::transform(references, references + count, values, [this](Reference reference) { return value(reference); });
}

double Instance::value(Reference reference) const {
  if (reference == reference::kTime) {
    return now_.time;
  }
  if (reference < table_.firstOutput()) {
    return now_.inputs[reference - reference::kDisplacement];
  }
  if (reference < table_.firstParameter()) {
    return now_.outputs[reference - table_.firstOutput()];
  }
  if (reference == table_.temperature()) {
    return now_.temperature().value_or(table_.variables()[reference].start.value());
  }
  const std::size_t parameter = reference - table_.firstParameter();
  const std::size_t free = now_.parameters.size();
  return parameter < free ? now_.parameters[parameter] : body_->calculated()[parameter - free];
}

void Instance::setDerivatives(const Reference* references, std::size_t count, const int* orders, const double* values) {
  refuseIf(count > 0 && (references == nullptr || orders == nullptr || values == nullptr),
           "set of a derivative: a pointer is null");
  require(count == 0 || now_.phase <= Phase::stepping, "set of a derivative");
  for (std::size_t i = 0; i < count; ++i) {
    const auto order = static_cast<std::size_t>(orders[i]);  // large, and refused, if negative
    refuseIf(data_.six || references[i] != reference::kDisplacement || order < 1 || order > kMostDerivatives,
             "derivative {} of variable {} is not supported; accepted: derivatives 1 to {} of the displacement",
             orders[i], references[i], kMostDerivatives);
    refuseIf(!element::Range::any().contains(values[i]),
             "derivative {} of the displacement: {} is not finite, or its magnitude exceeds {:g}", order, values[i],
             element::kLargestNumber);
    now_.derivative[order - 1] = values[i];
    has_derivatives_ = true;
  }
}

// Returns the component with these parameters. Throws std::exception if they describe no component.
Body Instance::build(const std::vector<double>& parameters) const {
  ComponentData changed = data_;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    table_.variables()[table_.firstParameter() + i].place.put(changed, parameters[i]);
  }
  return {changed, table_.calculatedValues(changed.modelElements())};
}

void Instance::settle() {
  if (!now_.settled) {
    body_ = build(now_.parameters);
    now_.outputs = body_->initialise(now_.inputs, now_.temperature());
    now_.settled = true;
  }
}

// Returns the tolerance of times [s]. The times of importer and instance differ by one rounding, 1e-16 of the time. A
// difference above 1e-9 of the time plus a millionth of the step means that a step was omitted or repeated, or ends
// beyond the stop time.
double Instance::roomFor(double size) const { return 1e-6 * size + 1e-9 * std::abs(now_.time); }

bool Instance::isInTime(double time, double size) const {
  return std::abs(time - now_.time) <= roomFor(size) && time + size <= now_.stop_time + roomFor(size);
}

// Returns the displacement at the end of a step and clears the derivatives.
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

void Instance::refuseStep(double time, double size) const {
  require(now_.phase == Phase::stepping, "step");
  refuseIf(!(size > 0.0) || !std::isfinite(size), "a step of {:g} s is not possible; accepted: greater than 0", size);
  refuseIf(std::abs(time - now_.time) <= roomFor(size),
           "the step would end at {:.9g} s; accepted: at most the stop time, {:.9g} s", time + size, now_.stop_time);
  throw std::invalid_argument(
      fmt::format("the step cannot begin at {:.9g} s; accepted: {:.9g} s, where the last step ended", time, now_.time));
}

void Instance::fail() {
  enter(Phase::failed);
  throw std::runtime_error(
      fmt::format("{} gives a force that is not finite; accepted: a reset, or the restore of a saved state",
                  data_.six ? "the pose" : fmt::format("displacement {:g} m", now_.inputs[0])));
}

void Instance::save(SavedState& state) const {
  require(now_.phase != Phase::failed, "save of the state");
  state.fingerprint = fingerprint_;
  state.standing = now_;
  state.memory.clear();
  if (now_.settled) {
    body_->save(state);
  }
}

void Instance::restore(const SavedState& state) {
  const Standing& saved = state.standing;
  refuseIf(state.fingerprint != fingerprint_ || saved.parameters.size() != now_.parameters.size(),
           "restore of a state: the state is not from this FMU");
  refuseIf(saved.phase == Phase::failed || (saved.phase > Phase::initialising && !saved.settled),
           "restore of a state: no simulation can continue from this state");
  // All that can fail comes first, so that an instance is changed as a whole or not at all.
  if (!saved.settled) {
    body_.reset();
  } else if (body_ && saved.parameters == now_.parameters) {
    body_->restore(state);
  } else {
    Body rebuilt = build(saved.parameters);
    rebuilt.restore(state);
    body_ = std::move(rebuilt);
  }
  now_ = saved;
  has_derivatives_ = now_.derivative != Standing().derivative;
}

}  // namespace rubber_suspension::fmi
