// FMI 3.0 for co-simulation on an instance.
#include "fmi/runtime/fmi3.h"

#include <string>

#include "fmi/runtime/guard.h"

namespace {

using rubber_suspension::fmi::guarded;
using rubber_suspension::fmi::Instance;
using rubber_suspension::fmi::Log;
using rubber_suspension::fmi::Status;

static_assert(static_cast<int>(Status::discard) == fmi3Discard && static_cast<int>(Status::error) == fmi3Error);

Log logTo(fmi3InstanceEnvironment environment, fmi3LogMessageCallback callback) {
  if (callback == nullptr) {
    return [](Status, const char*, const std::string&) {};
  }
  return [=](Status status, const char* category, const std::string& message) {
    callback(environment, static_cast<fmi3Status>(status), category, message.c_str());
  };
}

fmi3Instance refuseKind(fmi3InstanceEnvironment environment, fmi3LogMessageCallback callback,
                        const char* kind) noexcept {
  try {
    logTo(environment, callback)(Status::error, rubber_suspension::fmi::category::kError,
                                 std::string(kind) + "; accepted: co-simulation without event mode");
  } catch (...) {
  }
  return nullptr;
}

fmi3Status refuseCall(fmi3Instance handle, const char* what) {
  return guarded<fmi3Status>(
      handle, [&](Instance& instance) { return instance.error(std::string(what) + ": not supported by this FMU"); });
}

fmi3Status refuseType(fmi3Instance handle, std::size_t count, const char* type) {
  return guarded<fmi3Status>(
      handle, [&](Instance& instance) { return rubber_suspension::fmi::refuseType(instance, count, type); });
}

Status refuseCounts(Instance& instance) {
  return instance.error("the number of values is not that of the variables; accepted: one value each");
}

}  // namespace

const char* fmi3GetVersion() { return "3.0"; }

fmi3Status fmi3SetDebugLogging(fmi3Instance handle, fmi3Boolean on, std::size_t count, const fmi3String categories[]) {
  return guarded<fmi3Status>(handle, [&](Instance& instance) { return setLogging(instance, on, count, categories); });
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback callback) {
  return refuseKind(environment, callback, "model exchange");
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback callback,
                                               fmi3ClockUpdateCallback, fmi3LockPreemptionCallback,
                                               fmi3UnlockPreemptionCallback) {
  return refuseKind(environment, callback, "scheduled execution");
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String /*name*/, fmi3String token, fmi3String /*resources*/,
                                         fmi3Boolean /*visible*/, fmi3Boolean logging_on, fmi3Boolean event_mode_used,
                                         fmi3Boolean /*early_return_allowed*/, const fmi3ValueReference[], std::size_t,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback callback,
                                         fmi3IntermediateUpdateCallback) {
  if (event_mode_used) {
    return refuseKind(environment, callback, "event mode");
  }
  try {
    Instance* instance = rubber_suspension::fmi::makeInstance(token, logTo(environment, callback));
    if (instance != nullptr) {
      instance->logEvents(logging_on);
    }
    return instance;
  } catch (...) {
    return nullptr;
  }
}

void fmi3FreeInstance(fmi3Instance handle) { delete static_cast<Instance*>(handle); }

fmi3Status fmi3EnterInitializationMode(fmi3Instance handle, fmi3Boolean /*tolerance_defined*/,
                                       fmi3Float64 /*tolerance*/, fmi3Float64 start, fmi3Boolean stop_defined,
                                       fmi3Float64 stop) {
  return guarded<fmi3Status>(handle, [&](Instance& instance) {
    const Status status = instance.setTimes(start, stop_defined, stop);
    return status == Status::ok ? instance.enterInitialisation() : status;
  });
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance handle) {
  return guarded<fmi3Status>(handle, [](Instance& instance) { return instance.exitInitialisation(); });
}

fmi3Status fmi3Terminate(fmi3Instance handle) {
  return guarded<fmi3Status>(handle, [](Instance& instance) { return instance.terminate(); });
}

fmi3Status fmi3Reset(fmi3Instance handle) {
  return guarded<fmi3Status>(handle, [](Instance& instance) { return instance.reset(); });
}

fmi3Status fmi3GetFloat64(fmi3Instance handle, const fmi3ValueReference vr[], std::size_t count, fmi3Float64 value[],
                          std::size_t values) {
  return guarded<fmi3Status>(handle, [&](Instance& instance) {
    return values == count ? instance.get(vr, count, value) : refuseCounts(instance);
  });
}

fmi3Status fmi3SetFloat64(fmi3Instance handle, const fmi3ValueReference vr[], std::size_t count,
                          const fmi3Float64 value[], std::size_t values) {
  return guarded<fmi3Status>(handle, [&](Instance& instance) {
    return values == count ? instance.set(vr, count, value) : refuseCounts(instance);
  });
}

// All variables are of the type Float64; the standard wants the functions of all other types none the less.
#define RUBBER_SUSPENSION_REFUSE_TYPE(Type)                                                                        \
  fmi3Status fmi3Get##Type(fmi3Instance handle, const fmi3ValueReference[], std::size_t count, fmi3##Type[],       \
                           std::size_t) {                                                                          \
    return refuseType(handle, count, #Type);                                                                       \
  }                                                                                                                \
  fmi3Status fmi3Set##Type(fmi3Instance handle, const fmi3ValueReference[], std::size_t count, const fmi3##Type[], \
                           std::size_t) {                                                                          \
    return refuseType(handle, count, #Type);                                                                       \
  }

RUBBER_SUSPENSION_REFUSE_TYPE(Float32)
RUBBER_SUSPENSION_REFUSE_TYPE(Int8)
RUBBER_SUSPENSION_REFUSE_TYPE(UInt8)
RUBBER_SUSPENSION_REFUSE_TYPE(Int16)
RUBBER_SUSPENSION_REFUSE_TYPE(UInt16)
RUBBER_SUSPENSION_REFUSE_TYPE(Int32)
RUBBER_SUSPENSION_REFUSE_TYPE(UInt32)
RUBBER_SUSPENSION_REFUSE_TYPE(Int64)
RUBBER_SUSPENSION_REFUSE_TYPE(UInt64)
RUBBER_SUSPENSION_REFUSE_TYPE(Boolean)
RUBBER_SUSPENSION_REFUSE_TYPE(String)

#undef RUBBER_SUSPENSION_REFUSE_TYPE

fmi3Status fmi3GetBinary(fmi3Instance handle, const fmi3ValueReference[], std::size_t count, std::size_t[],
                         fmi3Binary[], std::size_t) {
  return refuseType(handle, count, "Binary");
}

fmi3Status fmi3SetBinary(fmi3Instance handle, const fmi3ValueReference[], std::size_t count, const std::size_t[],
                         const fmi3Binary[], std::size_t) {
  return refuseType(handle, count, "Binary");
}

fmi3Status fmi3GetClock(fmi3Instance handle, const fmi3ValueReference[], std::size_t count, fmi3Clock[]) {
  return refuseType(handle, count, "Clock");
}

fmi3Status fmi3SetClock(fmi3Instance handle, const fmi3ValueReference[], std::size_t count, const fmi3Clock[]) {
  return refuseType(handle, count, "Clock");
}

fmi3Status fmi3GetFMUState(fmi3Instance handle, fmi3FMUState* state) {
  return guarded<fmi3Status>(handle, [&](Instance& instance) { return saveTo(instance, state); });
}

fmi3Status fmi3SetFMUState(fmi3Instance handle, fmi3FMUState state) {
  return guarded<fmi3Status>(handle, [&](Instance& instance) { return restoreFrom(instance, state); });
}

fmi3Status fmi3FreeFMUState(fmi3Instance handle, fmi3FMUState* state) {
  return guarded<fmi3Status>(handle, [&](Instance& /*instance*/) { return rubber_suspension::fmi::freeState(state); });
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance handle, fmi3FMUState state, std::size_t* size) {
  return guarded<fmi3Status>(handle, [&](Instance& instance) { return sizeOfState(instance, state, size); });
}

fmi3Status fmi3SerializeFMUState(fmi3Instance handle, fmi3FMUState state, fmi3Byte bytes[], std::size_t size) {
  return guarded<fmi3Status>(
      handle, [&](Instance& instance) { return writeState(instance, state, reinterpret_cast<char*>(bytes), size); });
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance handle, const fmi3Byte bytes[], std::size_t size, fmi3FMUState* state) {
  return guarded<fmi3Status>(handle, [&](Instance& instance) {
    return readState(instance, reinterpret_cast<const char*>(bytes), size, state);
  });
}

fmi3Status fmi3EnterStepMode(fmi3Instance handle) { return refuseCall(handle, "step mode from event mode"); }

fmi3Status fmi3GetOutputDerivatives(fmi3Instance handle, const fmi3ValueReference[], std::size_t, const fmi3Int32[],
                                    fmi3Float64[], std::size_t) {
  return refuseCall(handle, "derivatives of outputs");
}

fmi3Status fmi3DoStep(fmi3Instance handle, fmi3Float64 time, fmi3Float64 size,
                      fmi3Boolean /*no_return_before_this_time*/, fmi3Boolean* event_needed, fmi3Boolean* terminate,
                      fmi3Boolean* early_return, fmi3Float64* last_successful_time) {
  return guarded<fmi3Status>(handle, [&](Instance& instance) {
    const Status status = instance.step(time, size);
    for (fmi3Boolean* flag : {event_needed, terminate, early_return}) {
      if (flag != nullptr) {
        *flag = false;
      }
    }
    if (last_successful_time != nullptr) {
      *last_successful_time = instance.time();
    }
    return status;
  });
}

fmi3Status fmi3EnterEventMode(fmi3Instance handle) { return refuseCall(handle, "event mode"); }
fmi3Status fmi3EnterConfigurationMode(fmi3Instance handle) { return refuseCall(handle, "configuration mode"); }
fmi3Status fmi3ExitConfigurationMode(fmi3Instance handle) { return refuseCall(handle, "configuration mode"); }
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance handle) { return refuseCall(handle, "discrete states"); }
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance handle) { return refuseCall(handle, "continuous time"); }
fmi3Status fmi3SetTime(fmi3Instance handle, fmi3Float64) { return refuseCall(handle, "set of the time"); }

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance handle, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
                                    fmi3Boolean*, fmi3Float64*) {
  return refuseCall(handle, "discrete states");
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance handle, fmi3Boolean, fmi3Boolean*, fmi3Boolean*) {
  return refuseCall(handle, "model exchange");
}

fmi3Status fmi3SetContinuousStates(fmi3Instance handle, const fmi3Float64[], std::size_t) {
  return refuseCall(handle, "continuous states");
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance handle, fmi3Float64[], std::size_t) {
  return refuseCall(handle, "continuous states");
}

fmi3Status fmi3GetEventIndicators(fmi3Instance handle, fmi3Float64[], std::size_t) {
  return refuseCall(handle, "event indicators");
}

fmi3Status fmi3GetContinuousStates(fmi3Instance handle, fmi3Float64[], std::size_t) {
  return refuseCall(handle, "continuous states");
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance handle, fmi3Float64[], std::size_t) {
  return refuseCall(handle, "continuous states");
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance handle, std::size_t*) {
  return refuseCall(handle, "event indicators");
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance handle, std::size_t*) {
  return refuseCall(handle, "continuous states");
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance handle, fmi3ValueReference, std::size_t*) {
  return refuseCall(handle, "dependencies of elements");
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance handle, fmi3ValueReference, std::size_t[], fmi3ValueReference[],
                                       std::size_t[], fmi3DependencyKind[], std::size_t) {
  return refuseCall(handle, "dependencies of elements");
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance handle, const fmi3ValueReference[], std::size_t,
                                        const fmi3ValueReference[], std::size_t, const fmi3Float64[], std::size_t,
                                        fmi3Float64[], std::size_t) {
  return refuseCall(handle, "directional derivatives");
}

fmi3Status fmi3GetAdjointDerivative(fmi3Instance handle, const fmi3ValueReference[], std::size_t,
                                    const fmi3ValueReference[], std::size_t, const fmi3Float64[], std::size_t,
                                    fmi3Float64[], std::size_t) {
  return refuseCall(handle, "adjoint derivatives");
}

fmi3Status fmi3GetIntervalDecimal(fmi3Instance handle, const fmi3ValueReference[], std::size_t, fmi3Float64[],
                                  fmi3IntervalQualifier[]) {
  return refuseCall(handle, "clocks");
}

fmi3Status fmi3GetIntervalFraction(fmi3Instance handle, const fmi3ValueReference[], std::size_t, fmi3UInt64[],
                                   fmi3UInt64[], fmi3IntervalQualifier[]) {
  return refuseCall(handle, "clocks");
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance handle, const fmi3ValueReference[], std::size_t, fmi3Float64[]) {
  return refuseCall(handle, "clocks");
}

fmi3Status fmi3GetShiftFraction(fmi3Instance handle, const fmi3ValueReference[], std::size_t, fmi3UInt64[],
                                fmi3UInt64[]) {
  return refuseCall(handle, "clocks");
}

fmi3Status fmi3SetIntervalDecimal(fmi3Instance handle, const fmi3ValueReference[], std::size_t, const fmi3Float64[]) {
  return refuseCall(handle, "clocks");
}

fmi3Status fmi3SetIntervalFraction(fmi3Instance handle, const fmi3ValueReference[], std::size_t, const fmi3UInt64[],
                                   const fmi3UInt64[]) {
  return refuseCall(handle, "clocks");
}

fmi3Status fmi3SetShiftDecimal(fmi3Instance handle, const fmi3ValueReference[], std::size_t, const fmi3Float64[]) {
  return refuseCall(handle, "clocks");
}

fmi3Status fmi3SetShiftFraction(fmi3Instance handle, const fmi3ValueReference[], std::size_t, const fmi3UInt64[],
                                const fmi3UInt64[]) {
  return refuseCall(handle, "clocks");
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance handle, fmi3ValueReference, fmi3Float64) {
  return refuseCall(handle, "scheduled execution");
}
