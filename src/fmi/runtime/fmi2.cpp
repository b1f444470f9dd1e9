// FMI 2.0 for co-simulation on an instance.
#include "fmi/runtime/fmi2.h"

#include <string>

#include "fmi/runtime/guard.h"

namespace {

using rubber_suspension::fmi::guarded;
using rubber_suspension::fmi::Instance;
using rubber_suspension::fmi::Log;
using rubber_suspension::fmi::Status;

static_assert(static_cast<int>(Status::discard) == fmi2Discard && static_cast<int>(Status::error) == fmi2Error);

// The logger reads its message as a format of printf, and # as a reference to a variable.
std::string escaped(const std::string& message) {
  std::string result;
  for (const char c : message) {
    result += c;
    if (c == '%' || c == '#') {
      result += c;
    }
  }
  return result;
}

Log logTo(const fmi2CallbackFunctions* functions, fmi2String name) {
  if (functions == nullptr || functions->logger == nullptr) {
    return [](Status, const char*, const std::string&) {};
  }
  return [logger = functions->logger, environment = functions->componentEnvironment,
          instance = std::string(name == nullptr ? "" : name)](Status status, const char* category,
                                                               const std::string& message) {
    logger(environment, instance.c_str(), static_cast<fmi2Status>(status), category, escaped(message).c_str());
  };
}

}  // namespace

const char* fmi2GetTypesPlatform() { return "default"; }

const char* fmi2GetVersion() { return "2.0"; }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, std::size_t count, const fmi2String categories[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return setLogging(instance, on != 0, count, categories); });
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String /*resources*/,
                              const fmi2CallbackFunctions* functions, fmi2Boolean /*visible*/, fmi2Boolean logging_on) {
  try {
    const Log log = logTo(functions, name);
    if (type != fmi2CoSimulation) {
      log(Status::error, rubber_suspension::fmi::category::kError, "model exchange; accepted: co-simulation");
      return nullptr;
    }
    Instance* instance = rubber_suspension::fmi::makeInstance(guid, log);
    if (instance != nullptr) {
      instance->logEvents(logging_on != 0);
    }
    return instance;
  } catch (...) {
    return nullptr;
  }
}

void fmi2FreeInstance(fmi2Component c) { delete static_cast<Instance*>(c); }

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean /*tolerance_defined*/, fmi2Real /*tolerance*/,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return instance.setTimes(start, stop_defined != 0, stop); });
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.enterInitialisation(); });
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.exitInitialisation(); });
}

fmi2Status fmi2Terminate(fmi2Component c) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.terminate(); });
}

fmi2Status fmi2Reset(fmi2Component c) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.reset(); });
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], std::size_t count, fmi2Real value[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return instance.get(vr, count, value); });
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference[], std::size_t count, fmi2Integer[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return refuseType(instance, count, "integer"); });
}

fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference[], std::size_t count, fmi2Boolean[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return refuseType(instance, count, "boolean"); });
}

fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference[], std::size_t count, fmi2String[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return refuseType(instance, count, "string"); });
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], std::size_t count, const fmi2Real value[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return instance.set(vr, count, value); });
}

fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference[], std::size_t count, const fmi2Integer[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return refuseType(instance, count, "integer"); });
}

fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference[], std::size_t count, const fmi2Boolean[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return refuseType(instance, count, "boolean"); });
}

fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference[], std::size_t count, const fmi2String[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return refuseType(instance, count, "string"); });
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return saveTo(instance, state); });
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return restoreFrom(instance, state); });
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
  return guarded<fmi2Status>(c, [&](Instance& /*instance*/) { return rubber_suspension::fmi::freeState(state); });
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, std::size_t* size) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return sizeOfState(instance, state, size); });
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], std::size_t size) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return writeState(instance, state, bytes, size); });
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], std::size_t size, fmi2FMUstate* state) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return readState(instance, bytes, size, state); });
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference[], std::size_t,
                                        const fmi2ValueReference[], std::size_t, const fmi2Real[], fmi2Real[]) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.error("directional derivatives: none"); });
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], std::size_t count,
                                       const fmi2Integer order[], const fmi2Real value[]) {
  return guarded<fmi2Status>(c, [&](Instance& instance) {
    if (count > 0 && (vr == nullptr || order == nullptr || value == nullptr)) {
      return instance.error("set of a derivative: a null pointer");
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (const Status status = instance.setDerivative(vr[i], order[i], value[i]); status != Status::ok) {
        return status;
      }
    }
    return Status::ok;
  });
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference[], std::size_t, const fmi2Integer[],
                                        fmi2Real[]) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.error("derivatives of outputs: none"); });
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real size, fmi2Boolean /*no_return_before_this_time*/) {
  return guarded<fmi2Status>(c, [&](Instance& instance) { return instance.step(time, size); });
}

fmi2Status fmi2CancelStep(fmi2Component c) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.error("cancel: no step is under way"); });
}

fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind, fmi2Status*) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.discard("status: no step is under way"); });
}

fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real* value) {
  return guarded<fmi2Status>(c, [&](Instance& instance) {
    if (kind != fmi2LastSuccessfulTime || value == nullptr) {
      return instance.discard("status: not a real number; accepted: the last successful time");
    }
    *value = instance.time();
    return Status::ok;
  });
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind, fmi2Integer*) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.discard("status: none is an integer"); });
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean* value) {
  return guarded<fmi2Status>(c, [&](Instance& instance) {
    if (kind != fmi2Terminated || value == nullptr) {
      return instance.discard("status: not a boolean; accepted: terminated");
    }
    *value = 0;
    return Status::ok;
  });
}

fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind, fmi2String*) {
  return guarded<fmi2Status>(c, [](Instance& instance) { return instance.discard("status: no step is under way"); });
}
