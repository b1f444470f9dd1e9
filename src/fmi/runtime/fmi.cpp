// FMI 2.0 and FMI 3.0 for co-simulation on an instance. No null pointer gets in, no exception gets out.
#include "fmi/runtime/fmi.h"

#include <exception>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>

#include "fmi/runtime/embedded.h"
#include "fmi/runtime/instance.h"

namespace {

using namespace rubber_suspension::fmi;

static_assert(static_cast<int>(Status::discard) == fmi2Discard && static_cast<int>(Status::error) == fmi2Error);
static_assert(static_cast<int>(Status::discard) == fmi3Discard && static_cast<int>(Status::error) == fmi3Error);

// Call `body` with the instance behind a handle. What it throws becomes a message and Status::error.
template <class Result, class Body>
Result guarded(void* handle, Body body) noexcept {
  if (handle == nullptr) {
    return static_cast<Result>(Status::error);
  }
  auto& instance = *static_cast<Instance*>(handle);
  try {
    try {
      return static_cast<Result>(body(instance));
    } catch (const std::exception& error) {
      return static_cast<Result>(instance.error(error.what()));
    }
  } catch (...) {  // where even the message fails, there is only the status left
    return static_cast<Result>(Status::error);
  }
}

void logNothing(Status /*status*/, const char* /*category*/, const std::string& /*message*/) {}

// The logger of FMI 2.0 reads its message as a format of printf, and # as a reference to a variable.
std::string escaped(const std::string& message) {
  std::string result;
  for (const char c : message) {
    result.append(c == '%' || c == '#' ? 2 : 1, c);
  }
  return result;
}

Log logTo(const fmi2CallbackFunctions* functions, fmiString name) {
  if (functions == nullptr || functions->logger == nullptr) {
    return logNothing;
  }
  return [logger = functions->logger, environment = functions->componentEnvironment,
          instance = std::string(name == nullptr ? "" : name)](Status status, const char* category,
                                                               const std::string& message) {
    logger(environment, instance.c_str(), static_cast<fmi2Status>(status), category, escaped(message).c_str());
  };
}

Log logTo(void* environment, fmi3LogMessageCallback callback) {
  if (callback == nullptr) {
    return logNothing;
  }
  return [=](Status status, const char* category, const std::string& message) {
    callback(environment, static_cast<fmi3Status>(status), category, message.c_str());
  };
}

// An instance of the component in this binary, or nullptr with a message. `token` is what modelDescription.xml has as
// GUID or instantiation token; `refused` is a kind of use that the importer asks for and does not get, or nullptr.
template <class... Logger>
void* instantiate(const char* token, bool logging_on, const char* refused, Logger... logger) noexcept {
  try {
    const Log log = logTo(logger...);
    const auto refuse = [&log](const std::string& reason) {
      log(Status::error, category::kError, reason);
      return nullptr;
    };
    try {
      if (refused != nullptr) {
        return refuse(std::string(refused) + "; accepted: co-simulation without event mode");
      }
      ComponentData data = fromJson(embeddedText());
      if (token == nullptr || data.guid != token) {
        return refuse("the GUID is not that of this binary, " + data.guid);
      }
      auto instance = std::make_unique<Instance>(std::move(data), log);
      instance->logEvents(logging_on);
      return instance.release();
    } catch (const std::exception& error) {
      return refuse(std::string("no instance: ") + error.what());
    }
  } catch (...) {
    return nullptr;
  }
}

// What a pointer of the importer points to. Throws for none, which becomes an error.
template <class Value>
Value& at(Value* pointer, const char* call) {
  return pointer != nullptr ? *pointer : throw std::invalid_argument(std::string(call) + ": a null pointer");
}

// Switch debugging on or off, for all categories or for those listed.
Status setLogging(Instance& instance, bool on, std::size_t count, const fmiString* categories) {
  bool events = count == 0;
  for (std::size_t i = 0; i < count; ++i) {
    const fmiString given = (&at(categories, "debug logging"))[i];
    const std::string name = given == nullptr ? "" : given;
    if (name != category::kEvents && name != category::kError && name != category::kDiscard) {
      return instance.error("debug logging: '" + name + "' is no category; accepted: logEvents, logStatusDiscard, " +
                            "logStatusError");
    }
    events = events || name == category::kEvents;
  }
  if (events) {
    instance.logEvents(on);
  }
  return Status::ok;
}

Status enterInitialisation(Instance& instance, double start, bool stop_defined, double stop) {
  const Status status = instance.setTimes(start, stop_defined, stop);
  return status == Status::ok ? instance.enterInitialisation() : status;
}

Status refuseCounts(Instance& instance) {
  return instance.error("the number of values is not that of the variables; accepted: one value each");
}

// For variables of a type that no FMU of this package has: fine as long as none is asked for.
Status refuseType(Instance& instance, std::size_t count, const char* type) {
  return count == 0 ? Status::ok
                    : instance.error(std::string("no variable is of the type ") + type + "; accepted: real numbers");
}

Status step(Instance& instance, double time, double size, std::initializer_list<bool*> flags, double* last_time) {
  const Status status = instance.step(time, size);
  for (bool* flag : flags) {
    if (flag != nullptr) {
      *flag = false;
    }
  }
  if (last_time != nullptr) {
    *last_time = instance.time();
  }
  return status;
}

Status setDerivatives(Instance& instance, const fmiReference* vr, std::size_t count, const int* order,
                      const double* value) {
  if (count > 0 && (vr == nullptr || order == nullptr || value == nullptr)) {
    return instance.error("set of a derivative: a null pointer");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (const Status status = instance.setDerivative(vr[i], order[i], value[i]); status != Status::ok) {
      return status;
    }
  }
  return Status::ok;
}

// Of a step that went before, since none is ever under way.
template <class Value>
Status getStatus(Instance& instance, bool known, const char* accepted, Value* value, Value found) {
  if (!known || value == nullptr) {
    return instance.discard(std::string("status: ") + accepted);
  }
  *value = found;
  return Status::ok;
}

// Save into the state that the importer holds, or into a new one where it holds none.
Status saveTo(Instance& instance, void** state) {
  void*& held = at(state, "save of the state");
  if (held != nullptr) {
    return instance.save(*static_cast<SavedState*>(held));
  }
  auto saved = std::make_unique<SavedState>();
  const Status status = instance.save(*saved);
  held = status == Status::ok ? saved.release() : nullptr;
  return status;
}

const SavedState& stateIn(const void* held, const char* call) { return at(static_cast<const SavedState*>(held), call); }

Status freeState(void** held) {
  if (held != nullptr) {
    delete static_cast<SavedState*>(*held);
    *held = nullptr;
  }
  return Status::ok;
}

Status sizeOfState(const void* held, std::size_t* size) {
  at(size, "size of a state") = serialise(stateIn(held, "size of a state")).size();
  return Status::ok;
}

Status writeState(const void* held, void* bytes, std::size_t size) {
  const std::string written = serialise(stateIn(held, "serialisation of a state"));
  if (size < written.size()) {
    throw std::invalid_argument("serialisation of a state: too few bytes");
  }
  written.copy(&at(static_cast<char*>(bytes), "serialisation of a state"), written.size());
  return Status::ok;
}

Status readState(const void* bytes, std::size_t size, void** held) {
  void*& state = at(held, "deserialisation of a state");
  auto read = std::make_unique<SavedState>(
      deserialise(&at(static_cast<const char*>(bytes), "deserialisation of a state"), size));
  freeState(held);
  state = read.release();
  return Status::ok;
}

}  // namespace

#define FMI_PLAIN(Result, name, parameters, ...) \
  Result name parameters { return __VA_ARGS__; }
#define FMI_CALL(Result, name, parameters, ...)                                                  \
  Result name parameters {                                                                       \
    return guarded<Result>(c, [&]([[maybe_unused]] Instance& instance) { return __VA_ARGS__; }); \
  }
#include "fmi/runtime/calls.h"
#undef FMI_CALL
#undef FMI_PLAIN
