// One instance of an FMU, as both versions of the standard see it: phases, variables, steps, saved states.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fmi/runtime/body.h"
#include "fmi/runtime/saved_state.h"
#include "fmi/runtime/variables.h"

namespace rubber_suspension::fmi {

/// What a call came to; the numbers are those of fmi2Status and fmi3Status.
enum class Status : int {
  ok = 0,
  discard = 2,  ///< refused, and nothing has happened: the importer may go on with something else
  error = 3,
};

/// Where messages go: what the call came to, the log category and the text.
using Log = std::function<void(Status status, const char* category, const std::string& message)>;

/// Categories of the log, as modelDescription.xml lists them.
namespace category {
constexpr const char* kError = "logStatusError";
constexpr const char* kDiscard = "logStatusDiscard";
constexpr const char* kEvents = "logEvents";
}  // namespace category

/// A component of one direction or of six that an importer drives. A step takes the displacement, linear in time, from
/// where it was to the input as it is set when the step is called, plus what its derivatives add over the step. So an
/// importer that sets the displacement of the end of the step gets the forces of a replay at the same times, to the
/// last bit.
///
/// Calls in a wrong order, unknown references and wrong times are errors that leave the instance as it was; values that
/// cannot be are discarded. Only a force that is not finite spoils an instance: then it takes a reset or a saved state.
/// Instances share nothing, so each may be driven by a thread of its own.
class Instance {
 public:
  /// Throws std::exception where the data is none.
  Instance(ComponentData data, Log log);

  Status setTimes(double start, bool stop_defined, double stop);
  Status enterInitialisation();
  Status exitInitialisation();
  Status terminate();
  Status reset();

  Status set(const Reference* references, std::size_t count, const double* values) {
    if (count == 1 && now_.phase == Phase::stepping && references != nullptr && values != nullptr &&
        references[0] == reference::kDisplacement && std::isfinite(values[0])) {
      now_.inputs[0] = values[0];
      return Status::ok;
    }
    return setAll(references, count, values);
  }

  Status get(const Reference* references, std::size_t count, double* values) {
    if (count == 1 && now_.phase == Phase::stepping && references != nullptr && values != nullptr &&
        references[0] == table_.firstOutput()) {
      values[0] = now_.outputs[0];
      return Status::ok;
    }
    return getAll(references, count, values);
  }

  /// Derivative of the displacement by time, of an order from 1 to kMostDerivatives; counts for the next step alone.
  Status setDerivative(Reference reference, int order, double value);

  /// Advance by a step [s] that begins at a time [s] and does not end after the stop time. Allocates nothing.
  Status step(double time, double size) {
    if (now_.phase != Phase::stepping || !(size > 0.0) || !std::isfinite(size) || !isInTime(time, size)) {
      return refuseStep(time, size);
    }
    if (has_derivatives_ || body_->isSix()) {
      return stepInFull(time, size);
    }
    now_.time = time + size;
    return body_->stepOne(size, now_.inputs[0], now_.outputs) ? Status::ok : fail();
  }

  double time() const { return now_.time; }

  /// Into a state of this instance, without allocation where it was filled before.
  Status save(SavedState& state);
  Status restore(const SavedState& state);

  /// Log categories that are for debugging can be switched.
  void logEvents(bool on) { log_events_ = on; }

  /// Log an error and return it.
  Status error(const std::string& message);
  Status discard(const std::string& message);

 private:
  Status setAll(const Reference* references, std::size_t count, const double* values);
  Status getAll(const Reference* references, std::size_t count, double* values);
  Status checkSet(Reference reference, double value);
  void assign(Reference reference, double value);
  double value(Reference reference) const;

  Body build(const std::vector<double>& parameters, std::vector<double>& calculated) const;
  void settle();
  double roomFor(double size) const;
  bool isInTime(double time, double size) const;
  Numbers extrapolated(double size);
  Status stepInFull(double time, double size);
  Status refuseStep(double time, double size);
  Status fail();
  Status refuseOrder(const std::string& what);
  Status enter(Phase phase);

  ComponentData data_;
  VariableTable table_;
  Log log_;
  bool log_events_ = false;
  std::uint64_t fingerprint_;

  Standing now_;
  bool has_derivatives_ = false;
  std::vector<double> calculated_;  // parameters that follow from those that can be set
  std::optional<Body> body_;        // none: parameters have changed
};

}  // namespace rubber_suspension::fmi
