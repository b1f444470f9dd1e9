// The calls of FMI 2.0.4 and FMI 3.0 for co-simulation (chapters 2 and 4 of both standards), one a row. FMI_PLAIN has
// what it returns, name, parameters and value; FMI_CALL has the version, name, parameters and what it does to an
// `instance`. fmi.h declares them by these rows, fmi.cpp defines them. Both are to be defined before. No include guard.

FMI_PLAIN(fmiString, fmi2GetTypesPlatform, (), "default")
FMI_PLAIN(fmiString, fmi2GetVersion, (), "2.0")
FMI_PLAIN(fmiString, fmi3GetVersion, (), "3.0")
FMI_PLAIN(void*, fmi2Instantiate,
          (fmiString name, fmi2Type type, fmiString guid, fmiString, const fmi2CallbackFunctions* functions,
           fmi2Boolean, fmi2Boolean logging_on),
          instantiate(guid, logging_on != 0, type == fmi2CoSimulation ? nullptr : "model exchange", functions, name))
FMI_PLAIN(void*, fmi3InstantiateCoSimulation,
          (fmiString, fmiString token, fmiString, bool, bool logging_on, bool event_mode_used, bool,
           const fmiReference[], std::size_t, void* environment, fmi3LogMessageCallback callback, fmi3Callback),
          instantiate(token, logging_on, event_mode_used ? "event mode" : nullptr, environment, callback))
FMI_PLAIN(void*, fmi3InstantiateModelExchange,
          (fmiString, fmiString, fmiString, bool, bool, void* environment, fmi3LogMessageCallback callback),
          instantiate(nullptr, false, "model exchange", environment, callback))
FMI_PLAIN(void*, fmi3InstantiateScheduledExecution,
          (fmiString, fmiString, fmiString, bool, bool, void* environment, fmi3LogMessageCallback callback,
           fmi3Callback, fmi3Callback, fmi3Callback),
          instantiate(nullptr, false, "scheduled execution", environment, callback))
FMI_PLAIN(void, fmi2FreeInstance, (void* c), delete static_cast<Instance*>(c))
FMI_PLAIN(void, fmi3FreeInstance, (void* c), delete static_cast<Instance*>(c))

#define FMI_BOTH(name, parameters, ...)      \
  FMI_CALL(2, name, parameters, __VA_ARGS__) \
  FMI_CALL(3, name, parameters, __VA_ARGS__)
FMI_BOTH(ExitInitializationMode, (void* c), instance.pass(Phase::initialising, Phase::stepping, "exit initialisation"))
FMI_BOTH(Terminate, (void* c), instance.pass(Phase::stepping, Phase::terminated, "terminate"))
FMI_BOTH(Reset, (void* c), instance.reset())
#undef FMI_BOTH

FMI_CALL(2, SetDebugLogging, (void* c, fmi2Boolean on, std::size_t count, const fmiString categories[]),
         setLogging(instance, on != 0, count, categories))
FMI_CALL(3, SetDebugLogging, (void* c, bool on, std::size_t count, const fmiString categories[]),
         setLogging(instance, on, count, categories))
FMI_CALL(2, SetupExperiment, (void* c, fmi2Boolean, double, double start, fmi2Boolean stop_defined, double stop),
         instance.setTimes(start, stop_defined != 0, stop))
FMI_CALL(2, EnterInitializationMode, (void* c), enterInitialisation(instance))
FMI_CALL(3, EnterInitializationMode, (void* c, bool, double, double start, bool stop_defined, double stop),
         instance.setTimes(start, stop_defined, stop), enterInitialisation(instance))

FMI_CALL(2, GetReal, (void* c, const fmiReference vr[], std::size_t count, double value[]),
         instance.get(vr, count, value))
FMI_CALL(2, SetReal, (void* c, const fmiReference vr[], std::size_t count, const double value[]),
         instance.set(vr, count, value))
FMI_CALL(3, GetFloat64, (void* c, const fmiReference vr[], std::size_t count, double value[], std::size_t values),
         requireAsMany(count, values), instance.get(vr, count, value))
FMI_CALL(3, SetFloat64, (void* c, const fmiReference vr[], std::size_t count, const double value[], std::size_t values),
         requireAsMany(count, values), instance.set(vr, count, value))

FMI_CALL(2, DoStep, (void* c, double time, double size, fmi2Boolean), instance.step(time, size))
FMI_CALL(3, DoStep,
         (void* c, double time, double size, bool, bool* event_needed, bool* terminate, bool* early_return,
          double* last_successful_time),
         step(instance, time, size, {event_needed, terminate, early_return}, last_successful_time))
FMI_CALL(2, SetRealInputDerivatives,
         (void* c, const fmiReference vr[], std::size_t count, const int order[], const double value[]),
         instance.setDerivatives(vr, count, order, value))

#define FMI_STATES(V, State, Deserialize, Byte)                                                             \
  FMI_CALL(V, Get##State, (void* c, void** state), saveTo(instance, state))                                 \
  FMI_CALL(V, Set##State, (void* c, void* state), instance.restore(stateIn(state, "restore of a state")))   \
  FMI_CALL(V, Free##State, (void* c, void** state), freeState(state))                                       \
  FMI_CALL(V, Serialized##State##Size, (void* c, void* state, std::size_t* size), sizeOfState(state, size)) \
  FMI_CALL(V, Serialize##State, (void* c, void* state, Byte bytes[], std::size_t size),                     \
           writeState(state, bytes, size))                                                                  \
  FMI_CALL(V, Deserialize##State, (void* c, const Byte bytes[], std::size_t size, void** state),            \
           readState(bytes, size, state))
FMI_STATES(2, FMUstate, DeSerialize, char)
FMI_STATES(3, FMUState, Deserialize, std::uint8_t)
#undef FMI_STATES

// No step is ever under way when one of these is called.
FMI_CALL(2, GetRealStatus, (void* c, fmi2StatusKind kind, double* value),
         getStatus(kind == fmi2LastSuccessfulTime, "not a real number; accepted: the last successful time", value,
                   instance.time()))
FMI_CALL(2, GetBooleanStatus, (void* c, fmi2StatusKind kind, fmi2Boolean* value),
         getStatus(kind == fmi2Terminated, "not a boolean; accepted: terminated", value, 0))
#define FMI_NO_STATUS(name, Value) \
  FMI_CALL(2, name, (void* c, fmi2StatusKind, Value*), throw Discarded("status: no step is under way"))
FMI_NO_STATUS(GetStatus, fmi2Status)
FMI_NO_STATUS(GetIntegerStatus, int)
FMI_NO_STATUS(GetStringStatus, fmiString)
#undef FMI_NO_STATUS

// All variables are real numbers; the standards want the calls for all other types none the less.
#define FMI_NO_TYPE(V, Type, get, set)                  \
  FMI_CALL(V, Get##Type, get, refuseType(count, #Type)) \
  FMI_CALL(V, Set##Type, set, refuseType(count, #Type))
#define FMI_LIST void *c, const fmiReference[], std::size_t count
#define FMI_NO_SIMPLE(V, Type, Value) FMI_NO_TYPE(V, Type, (FMI_LIST, Value[]), (FMI_LIST, const Value[]))
#define FMI_NO_COUNTED(Type, Value) \
  FMI_NO_TYPE(3, Type, (FMI_LIST, Value[], std::size_t), (FMI_LIST, const Value[], std::size_t))
FMI_NO_SIMPLE(2, Integer, int)
FMI_NO_SIMPLE(2, Boolean, fmi2Boolean)
FMI_NO_SIMPLE(2, String, fmiString)
FMI_NO_COUNTED(Float32, float)
FMI_NO_COUNTED(Int8, std::int8_t)
FMI_NO_COUNTED(UInt8, std::uint8_t)
FMI_NO_COUNTED(Int16, std::int16_t)
FMI_NO_COUNTED(UInt16, std::uint16_t)
FMI_NO_COUNTED(Int32, std::int32_t)
FMI_NO_COUNTED(UInt32, std::uint32_t)
FMI_NO_COUNTED(Int64, std::int64_t)
FMI_NO_COUNTED(UInt64, std::uint64_t)
FMI_NO_COUNTED(Boolean, bool)
FMI_NO_COUNTED(String, fmiString)
FMI_NO_TYPE(3, Binary, (FMI_LIST, std::size_t[], fmi3Binary[], std::size_t),
            (FMI_LIST, const std::size_t[], const fmi3Binary[], std::size_t))
FMI_NO_SIMPLE(3, Clock, bool)
#undef FMI_NO_COUNTED
#undef FMI_NO_SIMPLE
#undef FMI_LIST
#undef FMI_NO_TYPE

// What this package offers in neither version.
#define FMI_REFUSED(V, name, what, parameters) \
  FMI_CALL(V, name, parameters, throw std::runtime_error(what ": not supported by this FMU"))
#define FMI_LIST void *c, const fmiReference[], std::size_t
#define FMI_DERIVATIVE void *c, const fmiReference[], std::size_t, const fmiReference[], std::size_t, const double[]
FMI_REFUSED(2, GetDirectionalDerivative, "directional derivatives", (FMI_DERIVATIVE, double[]))
FMI_REFUSED(2, GetRealOutputDerivatives, "derivatives of outputs", (FMI_LIST, const int[], double[]))
FMI_REFUSED(2, CancelStep, "a step that can be cancelled", (void* c))
FMI_REFUSED(3, EnterStepMode, "step mode from event mode", (void* c))
FMI_REFUSED(3, EnterEventMode, "event mode", (void* c))
FMI_REFUSED(3, EnterConfigurationMode, "configuration mode", (void* c))
FMI_REFUSED(3, ExitConfigurationMode, "configuration mode", (void* c))
FMI_REFUSED(3, EvaluateDiscreteStates, "discrete states", (void* c))
FMI_REFUSED(3, UpdateDiscreteStates, "discrete states", (void* c, bool*, bool*, bool*, bool*, bool*, double*))
FMI_REFUSED(3, EnterContinuousTimeMode, "continuous time", (void* c))
FMI_REFUSED(3, CompletedIntegratorStep, "model exchange", (void* c, bool, bool*, bool*))
FMI_REFUSED(3, SetTime, "set of the time", (void* c, double))
FMI_REFUSED(3, SetContinuousStates, "continuous states", (void* c, const double[], std::size_t))
FMI_REFUSED(3, GetContinuousStates, "continuous states", (void* c, double[], std::size_t))
FMI_REFUSED(3, GetContinuousStateDerivatives, "continuous states", (void* c, double[], std::size_t))
FMI_REFUSED(3, GetNominalsOfContinuousStates, "continuous states", (void* c, double[], std::size_t))
FMI_REFUSED(3, GetNumberOfContinuousStates, "continuous states", (void* c, std::size_t*))
FMI_REFUSED(3, GetEventIndicators, "event indicators", (void* c, double[], std::size_t))
FMI_REFUSED(3, GetNumberOfEventIndicators, "event indicators", (void* c, std::size_t*))
FMI_REFUSED(3, GetNumberOfVariableDependencies, "dependencies of elements", (void* c, fmiReference, std::size_t*))
FMI_REFUSED(3, GetVariableDependencies, "dependencies of elements",
            (void* c, fmiReference, std::size_t[], fmiReference[], std::size_t[], fmi3Enum[], std::size_t))
FMI_REFUSED(3, GetDirectionalDerivative, "directional derivatives",
            (FMI_DERIVATIVE, std::size_t, double[], std::size_t))
FMI_REFUSED(3, GetAdjointDerivative, "adjoint derivatives", (FMI_DERIVATIVE, std::size_t, double[], std::size_t))
FMI_REFUSED(3, GetOutputDerivatives, "derivatives of outputs", (FMI_LIST, const std::int32_t[], double[], std::size_t))
FMI_REFUSED(3, GetIntervalDecimal, "clocks", (FMI_LIST, double[], fmi3Enum[]))
FMI_REFUSED(3, SetIntervalDecimal, "clocks", (FMI_LIST, const double[]))
FMI_REFUSED(3, GetIntervalFraction, "clocks", (FMI_LIST, std::uint64_t[], std::uint64_t[], fmi3Enum[]))
FMI_REFUSED(3, SetIntervalFraction, "clocks", (FMI_LIST, const std::uint64_t[], const std::uint64_t[]))
FMI_REFUSED(3, GetShiftDecimal, "clocks", (FMI_LIST, double[]))
FMI_REFUSED(3, SetShiftDecimal, "clocks", (FMI_LIST, const double[]))
FMI_REFUSED(3, GetShiftFraction, "clocks", (FMI_LIST, std::uint64_t[], std::uint64_t[]))
FMI_REFUSED(3, SetShiftFraction, "clocks", (FMI_LIST, const std::uint64_t[], const std::uint64_t[]))
FMI_REFUSED(3, ActivateModelPartition, "scheduled execution", (void* c, fmiReference, double))
#undef FMI_DERIVATIVE
#undef FMI_LIST
#undef FMI_REFUSED
