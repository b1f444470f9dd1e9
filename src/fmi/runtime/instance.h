// One instance of an FMU, for both versions of the standard: phases, variables, steps, saved states.
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

/// Status that a call returns, with the numbers of fmi2Status and fmi3Status.
enum class Status : int { ok = 0, discard = 2, error = 3 };

/// Thrown if a call is refused and has changed nothing, so that the importer may continue.
class Discarded : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

using Log = std::function<void(Status status, const std::string& message)>;

struct LogCategory {
  Status status;  ///< status of its messages
  const char* name;
  const char* description;
};
constexpr LogCategory kLogCategories[] = {{Status::ok, "logEvents", "changes of the phase"},
                                          {Status::discard, "logStatusDiscard", "refused values"},
                                          {Status::error, "logStatusError", "errors"}};

/// Simulates a component of one direction or of six directions for an importer. During a step the displacement moves
/// linearly in time to the input at the time of the call, plus the increment from its derivatives. So an importer that
/// sets the displacement of the end of each step receives the forces of a replay at the same times, bit by bit.
///
/// Calls in a wrong order, unknown references and wrong times throw std::exception and do not change the instance.
/// Values out of range throw Discarded. After a force that is not finite, the importer has to reset the instance or to
/// restore a saved state. Instances share no data, so each may run in its own thread.
class Instance {
 public:
  /// Throws std::exception if the data describe no component.
  Instance(ComponentData data, Log log);

  void setTimes(double start, bool stop_defined, double stop);

  /// Changes the phase. The change to Phase::stepping builds and initialises the component.
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

  /// Sets time derivatives of the displacement, of orders 1 to kMostDerivatives, for the next step only.
  void setDerivatives(const Reference* references, std::size_t count, const int* orders, const double* values);

  /// Advances by `size` [s] from `time` [s], at most to the stop time. Allocates nothing.
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

  /// Saves into a state. Allocates nothing if this instance has already saved into it.
  void save(SavedState& state) const;
  void restore(const SavedState& state);

  /// Switches messages about changes of the phase on or off.
  void logEvents(bool on) { log_events_ = on; }

  /// Logs the status of a call with a message and returns the status.
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
  std::optional<Body> body_;  // empty after a change of the parameters
};

}  // namespace rubber_suspension::fmi
