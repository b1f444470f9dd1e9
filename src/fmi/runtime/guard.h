// What stands between the C functions of both versions and an instance: no null pointer gets in, no exception gets out.
#pragma once

#include <cstring>
#include <exception>
#include <memory>
#include <string>

#include "fmi/runtime/embedded.h"
#include "fmi/runtime/instance.h"

namespace rubber_suspension::fmi {

/// Log an error; where even that fails there is only the status left.
inline Status errorOf(Instance& instance, const char* message) noexcept {
  try {
    return instance.error(message);
  } catch (...) {
    return Status::error;
  }
}

/// Call `body` with the instance behind a handle. What it throws becomes a message and Status::error.
template <class Result, class Body>
Result guarded(void* handle, Body body) noexcept {
  if (handle == nullptr) {
    return static_cast<Result>(Status::error);
  }
  auto& instance = *static_cast<Instance*>(handle);
  try {
    return static_cast<Result>(body(instance));
  } catch (const std::exception& error) {
    return static_cast<Result>(errorOf(instance, error.what()));
  } catch (...) {
    return static_cast<Result>(Status::error);
  }
}

/// An instance of the component in this binary, or nullptr with a message. `token` is what modelDescription.xml has as
/// GUID or instantiation token.
inline Instance* makeInstance(const char* token, const Log& log) noexcept {
  try {
    try {
      ComponentData data = fromJson(embeddedText());
      if (token == nullptr || data.guid != token) {
        log(Status::error, category::kError, "the GUID is not that of this binary, " + data.guid);
        return nullptr;
      }
      return std::make_unique<Instance>(std::move(data), log).release();
    } catch (const std::exception& error) {
      log(Status::error, category::kError, std::string("no instance: ") + error.what());
    }
  } catch (...) {
  }
  return nullptr;
}

/// Save into the state that the importer holds, or into a new one where it holds none.
inline Status saveTo(Instance& instance, void** held) {
  if (held == nullptr) {
    return instance.error("save of the state: a null pointer");
  }
  if (*held != nullptr) {
    return instance.save(*static_cast<SavedState*>(*held));
  }
  auto state = std::make_unique<SavedState>();
  const Status status = instance.save(*state);
  if (status == Status::ok) {
    *held = state.release();
  }
  return status;
}

inline Status restoreFrom(Instance& instance, const void* held) {
  return held == nullptr ? instance.error("restore of a state: a null pointer")
                         : instance.restore(*static_cast<const SavedState*>(held));
}

inline Status freeState(void** held) {
  if (held != nullptr) {
    delete static_cast<SavedState*>(*held);
    *held = nullptr;
  }
  return Status::ok;
}

inline Status sizeOfState(Instance& instance, const void* held, std::size_t* size) {
  if (held == nullptr || size == nullptr) {
    return instance.error("size of a state: a null pointer");
  }
  *size = serialisedSize(*static_cast<const SavedState*>(held));
  return Status::ok;
}

inline Status writeState(Instance& instance, const void* held, char* bytes, std::size_t size) {
  if (held == nullptr || bytes == nullptr) {
    return instance.error("serialisation of a state: a null pointer");
  }
  const auto& state = *static_cast<const SavedState*>(held);
  if (size < serialisedSize(state)) {
    return instance.error("serialisation of a state: too few bytes");
  }
  serialise(state, bytes);
  return Status::ok;
}

inline Status readState(Instance& instance, const char* bytes, std::size_t size, void** held) {
  if (bytes == nullptr || held == nullptr) {
    return instance.error("deserialisation of a state: a null pointer");
  }
  auto state = std::make_unique<SavedState>(deserialise(bytes, size));
  freeState(held);
  *held = state.release();
  return Status::ok;
}

/// Switch debugging on or off, for all categories or for those listed.
inline Status setLogging(Instance& instance, bool on, std::size_t count, const char* const* categories) {
  if (count > 0 && categories == nullptr) {
    return instance.error("debug logging: a null pointer");
  }
  bool events = count == 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = categories[i] == nullptr ? "" : categories[i];
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

/// For variables of a type that no FMU of this package has: fine as long as none is asked for.
inline Status refuseType(Instance& instance, std::size_t count, const char* type) {
  return count == 0 ? Status::ok
                    : instance.error(std::string("no variable is of the type ") + type + "; accepted: real numbers");
}

}  // namespace rubber_suspension::fmi
