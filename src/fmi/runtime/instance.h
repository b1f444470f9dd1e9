// One instance of an FMU, as both versions of the standard see it: phases, variables, steps, saved states.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "element/largest_number.h"
#include "fmi/runtime/body.h"
#include "fmi/runtime/saved_state.h"
#include "fmi/runtime/variables.h"

namespace rubber_suspension::fmi {

/// Result of a call; the numbers are those of fmi2Status and fmi3Status.
enum class Status : int { ok = 0, discard = 2, error = 3 };

/// Thrown by a call that is refused where nothing has happened and the importer may go on with something else. Whatever
/// else is thrown makes the call an error.
class Discarded : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where messages go: what the call came to and the text.
using Log = std::function<void(Status status, const std::string& message)>;

/// A category of the log.
struct LogCategory {
  Status status;  ///< of its messages
  const char* name;
  const char* description;
};
constexpr LogCategory kLogCategories[] = {{Status::ok, "logEvents", "changes of the phase"},
                                          {Status::discard, "logStatusDiscard", "refused values"},
                                          {Status::error, "logStatusError", "errors"}};

/// A component of one direction or of six that an importer drives. A step takes the displacement, linear in time, from
/// where it was to the input as it is set when the step is called, plus what its derivatives add over the step. So an
/// importer that sets the displacement of the end of the step gets the forces of a replay at the same times, to the
/// last bit.
///
/// Calls in a wrong order, unknown references and wrong times are errors that leave the instance as it was; values that
/// cannot be are discarded. Only a force that is not finite spoils an instance: then it takes a reset or a saved state.
/// All of them throw. Instances share nothing, so each may be driven by a thread of its own.
class Instance {
 public:
  /// Throws std::exception where the data is none.
  Instance(ComponentData data, Log log);

  void setTimes(double start, bool stop_defined, double stop);

  /// From one phase to the next; before the first step the component is built and initialised.
  void pass(Phase from, Phase to, const char* call);
  void reset();

  void set(const Reference* references, std::size_t count, const double* values) {
    if (count == 1 && now_.phase == Phase::stepping && references != nullptr && values != nullptr &&
        references[0] == reference::kDisplacement && std::abs(values[0]) <= element::kLargestNumber) {
      now_.inputs[0] = values[0];
    } else {
      setAll(references, count, values);
    }
  }

  void get(const Reference* references, std::size_t count, double* values) {
    if (count == 1 && now_.phase == Phase::stepping && references != nullptr && values != nullptr &&
        references[0] == table_.firstOutput()) {
      values[0] = now_.outputs[0];
    } else {
      getAll(references, count, values);
    }
  }

  /// Derivatives of the displacement by time, of orders from 1 to kMostDerivatives; they count for the next step alone.
  void setDerivatives(const Reference* references, std::size_t count, const int* orders, const double* values);

  /// Advances by a step [s] that begins at a time [s] and does not end after the stop time. Allocates nothing.
  void step(double time, double size) {
    if (now_.phase != Phase::stepping || !(size > 0.0) || !std::isfinite(size) || !isInTime(time, size)) {
      refuseStep(time, size);
    }
    const bool finite = has_derivatives_ ? body_->step(size, extrapolated(size), now_.outputs)
                                         : body_->step(size, now_.inputs, now_.outputs);
    now_.time = time + size;
    if (!finite) {
      fail();
    }
  }

  double time() const { return now_.time; }

  /// Into a state of this instance, without allocation where it was filled before.
  void save(SavedState& state) const;
  void restore(const SavedState& state);

  /// Log categories that are for debugging can be switched.
  void logEvents(bool on) { log_events_ = on; }

  /// Log what a call came to, and return it.
  Status tell(Status status, const std::string& message) const;

 private:
  void setAll(const Reference* references, std::size_t count, const double* values);
  void getAll(const Reference* references, std::size_t count, double* values);
  void checkSet(Reference reference, double value) const;
  void assign(Reference reference, double value);
  double value(Reference reference) const;

  Body build(const std::vector<double>& parameters) const;
  void settle();
  double roomFor(double size) const;
  bool isInTime(double time, double size) const;
  Numbers extrapolated(double size);
  [[noreturn]] void refuseStep(double time, double size) const;
  [[noreturn]] void fail();
  void require(bool in_phase, const char* call) const;
  void enter(Phase phase);

  ComponentData data_;
  VariableTable table_;
  Log log_;
  bool log_events_ = false;
  std::uint64_t fingerprint_;

  Standing now_;
  bool has_derivatives_ = false;
  std::optional<Body> body_;  // none: parameters have changed
};

}  // namespace rubber_suspension::fmi
