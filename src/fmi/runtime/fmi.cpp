// The calls of FMI 2.0 and FMI 3.0 for co-simulation. They refuse null pointers, and no exception leaves them.
#include "fmi/runtime/fmi.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>

#include "element/refuse.h"
#include "fmi/runtime/embedded.h"
#include "fmi/runtime/instance.h"

#ifdef RUBBER_SUSPENSION_BUILT_IN  // when compiled from the sources in an FMU
#include "component_text.h"
#else
#define RUBBER_SUSPENSION_COMPONENT_TEXT ""
#endif

namespace {

using namespace rubber_suspension::fmi;
using rubber_suspension::element::refuseIf;

static_assert(static_cast<int>(Status::discard) == fmi2Discard && static_cast<int>(Status::error) == fmi2Error);
static_assert(static_cast<int>(Status::discard) == fmi3Discard && static_cast<int>(Status::error) == fmi3Error);

static_assert(sizeof(RUBBER_SUSPENSION_COMPONENT_TEXT) <= kCapacity, "more text than the block holds");

// Returns the text in the block, which is empty until the exporter writes to it.
std::string embeddedText() {
  // The block is volatile, because the exporter changes its content in the binary, and not constant, so that it is in a
  // section with initialised data.
  static volatile EmbeddedBlock block = {RUBBER_SUSPENSION_BLOCK_MARKER, sizeof(RUBBER_SUSPENSION_COMPONENT_TEXT) - 1,
                                         RUBBER_SUSPENSION_COMPONENT_TEXT};
  const std::uint64_t written = block.size;
  std::string text(std::min<std::uint64_t>(written, kCapacity), '\0');
  std::copy_n(block.text, text.size(), text.begin());
  return text;
}

// Calls `body` with the instance that a handle refers to. An exception becomes a message and a status.
template <class Body>
Status guarded(void* handle, Body body) noexcept {
  if (handle == nullptr) {
    return Status::error;
  }
  auto& instance = *static_cast<Instance*>(handle);
  try {
    try {
      body(instance);
      return Status::ok;
    } catch (const Discarded& refused) {
      return instance.tell(Status::discard, refused.what());
    } catch (const std::exception& error) {
      return instance.tell(Status::error, error.what());
    }
  } catch (...) {  // if logging throws, only the status is returned
    return Status::error;
  }
}

const char* categoryOf(Status status) {
  return std::find_if(std::begin(kLogCategories), std::end(kLogCategories),
                      [&](const LogCategory& category) { return category.status == status; })
      ->name;
}

Log logTo(const fmi2CallbackFunctions* functions, fmiString name) {
  return [functions = functions == nullptr ? fmi2CallbackFunctions{} : *functions,
          instance = std::string(name == nullptr ? "" : name)](Status status, const std::string& message) {
    if (functions.logger != nullptr) {
      // The logger reads % as in a format of printf and # as a reference to a variable.
      const std::string text = std::regex_replace(message, std::regex("[%#]"), "$&$&");
      functions.logger(functions.componentEnvironment, instance.c_str(), static_cast<fmi2Status>(status),
                       categoryOf(status), text.c_str());
    }
  };
}

Log logTo(void* environment, fmi3LogMessageCallback callback) {
  return [=](Status status, const std::string& message) {
    if (callback != nullptr) {
      callback(environment, static_cast<fmi3Status>(status), categoryOf(status), message.c_str());
    }
  };
}

// Returns an instance of the component in this binary, or nullptr with a message. `token` is the GUID or instantiation
// token of modelDescription.xml. `refused` is nullptr, or names a requested kind of use that is not supported.
template <class... Logger>
void* instantiate(const char* token, bool logging_on, const char* refused, Logger... logger) noexcept {
  try {
    const Log log = logTo(logger...);
    try {
      refuseIf(refused != nullptr, "{} is not supported; accepted: co-simulation without event mode", refused);
      ComponentData data = fromJson(embeddedText());
      refuseIf(token == nullptr || data.guid != token, "the GUID differs from the GUID of this binary, {}", data.guid);
      auto instance = std::make_unique<Instance>(std::move(data), log);
      instance->logEvents(logging_on);
      return instance.release();
    } catch (const std::exception& error) {
      log(Status::error, std::string("the instance cannot be created: ") + error.what());
    }
  } catch (...) {  // logging threw as well
  }
  return nullptr;
}

// Returns the value to which a pointer of the importer points. Throws std::invalid_argument for a null pointer.
template <class Value>
Value& at(Value* pointer, const char* call) {
  return pointer != nullptr ? *pointer : throw std::invalid_argument(std::string(call) + ": the pointer is null");
}

void setLogging(Instance& instance, bool on, std::size_t count, const fmiString* categories) {
  bool events = count == 0;
  for (std::size_t i = 0; i < count; ++i) {
    const fmiString given = (&at(categories, "debug logging"))[i];
    const std::string name = given == nullptr ? "" : given;
    refuseIf(std::none_of(std::begin(kLogCategories), std::end(kLogCategories),
                          [&](const LogCategory& category) { return category.name == name; }),
             "debug logging: '{}' is not a category; accepted: logEvents, logStatusDiscard, logStatusError", name);
    events = events || name == categoryOf(Status::ok);
  }
  if (events) {
    instance.logEvents(on);
  }
}

void requireAsMany(std::size_t count, std::size_t values) {
  refuseIf(values != count, "the numbers of values and variables differ; accepted: one value for each variable");
}

void refuseType(std::size_t count, const char* type) {
  refuseIf(count > 0, "no variable has the type {}; accepted: real numbers", type);
}

void refuse(const char* call) { refuseIf(true, "{}: not supported by this FMU", call); }

void step(Instance& instance, double time, double size, std::initializer_list<bool*> flags, double* last_time) {
  for (bool* flag : flags) {
    if (flag != nullptr) {
      *flag = false;
    }
  }
  double ignored = 0.0;
  double& reached = last_time == nullptr ? ignored : *last_time;
  reached = instance.time();  // the result if the step is refused
  instance.step(time, size);
  reached = instance.time();
}

// Gives the importer a value about the last step, since no step is ever pending. Throws if the value is not `known`.
template <class Value>
void getStatus(bool known, const char* accepted, Value* value, Value found) {
  refuseIf<Discarded>(!known || value == nullptr, "status: {}", accepted);
  *value = found;
}

// Saves into the given state, or into a new one if the importer gives a null pointer.
void saveTo(const Instance& instance, void** state) {
  void*& held = at(state, "save of the state");
  auto fresh = held == nullptr ? std::make_unique<SavedState>() : nullptr;
  instance.save(fresh ? *fresh : *static_cast<SavedState*>(held));
  held = fresh ? fresh.release() : held;
}

const SavedState& stateIn(const void* held, const char* call) { return at(static_cast<const SavedState*>(held), call); }

void freeState(void** held) {
  if (held != nullptr) {
    delete static_cast<SavedState*>(std::exchange(*held, nullptr));
  }
}

void sizeOfState(const void* held, std::size_t* size) {
  at(size, "size of a state") = serialise(stateIn(held, "size of a state")).size();
}

void writeState(const void* held, void* bytes, std::size_t size) {
  const std::string written = serialise(stateIn(held, "serialisation of a state"));
  refuseIf(size < written.size(), "serialisation of a state: the buffer has too few bytes");
  written.copy(&at(static_cast<char*>(bytes), "serialisation of a state"), written.size());
}

void readState(const void* bytes, std::size_t size, void** held) {
  void*& state = at(held, "deserialisation of a state");
  auto read = std::make_unique<SavedState>(
      deserialise(&at(static_cast<const char*>(bytes), "deserialisation of a state"), size));
  freeState(held);
  state = read.release();
}

}  // namespace

#define FMI_PLAIN(Result, name, parameters, ...) \
  Result name parameters { return __VA_ARGS__; }
#define FMI_CALL(V, name, parameters, ...)                                                                     \
  fmi##V##Status fmi##V##name parameters {                                                                     \
    return static_cast<fmi##V##Status>(guarded(c, [&]([[maybe_unused]] Instance& instance) { __VA_ARGS__; })); \
  }
#include "fmi/runtime/calls.h"
#undef FMI_CALL
#undef FMI_PLAIN
