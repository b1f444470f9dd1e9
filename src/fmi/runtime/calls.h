// The calls of FMI 2.0.4 and FMI 3.0 for co-simulation (chapters 2 and 4 of both standards), one per row. The arguments
// of FMI_PLAIN are the type of the result, the name, the parameters and the result; those of FMI_CALL are the version,
// the name, the parameters and a statement that uses `instance`. fmi.h and fmi.cpp define both macros and include this
// file, to declare and to define the calls. So there is no include guard.

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

// Calls that are the same in both versions except for types.
#define FMI_ALIKE(V, Boolean, State, Deserialize, Byte)                                                     \
  FMI_PLAIN(void, fmi##V##FreeInstance, (void* c), delete static_cast<Instance*>(c))                        \
  FMI_CALL(V, SetDebugLogging, (void* c, Boolean on, std::size_t count, const fmiString categories[]),      \
           setLogging(instance, on != 0, count, categories))                                                \
  FMI_CALL(V, ExitInitializationMode, (void* c),                                                            \
           instance.pass(Phase::initialising, Phase::stepping, "exit initialisation"))                      \
  FMI_CALL(V, Terminate, (void* c), instance.pass(Phase::stepping, Phase::terminated, "terminate"))         \
  FMI_CALL(V, Reset, (void* c), instance.reset())                                                           \
  FMI_CALL(V, Get##State, (void* c, void** state), saveTo(instance, state))                                 \
  FMI_CALL(V, Set##State, (void* c, void* state), instance.restore(stateIn(state, "restore of a state")))   \
  FMI_CALL(V, Free##State, (void* c, void** state), freeState(state))                                       \
  FMI_CALL(V, Serialized##State##Size, (void* c, void* state, std::size_t* size), sizeOfState(state, size)) \
  FMI_CALL(V, Serialize##State, (void* c, void* state, Byte bytes[], std::size_t size),                     \
           writeState(state, bytes, size))                                                                  \
  FMI_CALL(V, Deserialize##State, (void* c, const Byte bytes[], std::size_t size, void** state),            \
           readState(bytes, size, state))
FMI_ALIKE(2, fmi2Boolean, FMUstate, DeSerialize, char)
FMI_ALIKE(3, bool, FMUState, Deserialize, std::uint8_t)
#undef FMI_ALIKE

FMI_CALL(2, SetupExperiment, (void* c, fmi2Boolean, double, double start, fmi2Boolean stop_defined, double stop),
         instance.setTimes(start, stop_defined != 0, stop))
FMI_CALL(2, EnterInitializationMode, (void* c),
         instance.pass(Phase::instantiated, Phase::initialising, "enter initialisation"))
FMI_CALL(3, EnterInitializationMode, (void* c, bool, double, double start, bool stop_defined, double stop),
         instance.setTimes(start, stop_defined, stop),
         instance.pass(Phase::instantiated, Phase::initialising, "enter initialisation"))

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

// The status of the last step. No step is in progress when one of these functions is called.
FMI_CALL(2, GetRealStatus, (void* c, fmi2StatusKind kind, double* value),
         getStatus(kind == fmi2LastSuccessfulTime,
                   "this status is not a real number; accepted: the last successful time", value, instance.time()))
FMI_CALL(2, GetBooleanStatus, (void* c, fmi2StatusKind kind, fmi2Boolean* value),
         getStatus(kind == fmi2Terminated, "this status is not a boolean; accepted: terminated", value, 0))
#define FMI_NO_STATUS(name, Value) \
  FMI_CALL(2, name, (void* c, fmi2StatusKind, Value*), throw Discarded("status: no step is in progress"))
FMI_NO_STATUS(GetStatus, fmi2Status)
FMI_NO_STATUS(GetIntegerStatus, int)
FMI_NO_STATUS(GetStringStatus, fmiString)
#undef FMI_NO_STATUS

// All variables are real numbers, but the standards require the calls for other types as well.
#define FMI_NO_TYPE(V, Type, get, set)                  \
  FMI_CALL(V, Get##Type, get, refuseType(count, #Type)) \
  FMI_CALL(V, Set##Type, set, refuseType(count, #Type))
#define FMI_LIST void *c, const fmiReference[], [[maybe_unused]] std::size_t count
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
#undef FMI_NO_TYPE

// Calls that this package does not support. The calls of FMI 3.0 are grouped by their parameters.
#define FMI_DERIVATIVE FMI_LIST, const fmiReference[], std::size_t, const double[]
#define FMI_REFUSE(r, parameters, name) FMI_CALL(3, name, parameters, refuse(BOOST_PP_STRINGIZE(name)))
#define FMI_REFUSED(parameters, names) BOOST_PP_SEQ_FOR_EACH(FMI_REFUSE, parameters, names)
FMI_CALL(2, CancelStep, (void* c), refuse("CancelStep"))
FMI_CALL(2, GetDirectionalDerivative, (FMI_DERIVATIVE, double[]), refuse("GetDirectionalDerivative"))
FMI_CALL(2, GetRealOutputDerivatives, (FMI_LIST, const int[], double[]), refuse("GetRealOutputDerivatives"))
FMI_REFUSED((void* c), (EnterStepMode)(EnterEventMode)(EnterConfigurationMode)(ExitConfigurationMode))
FMI_REFUSED((void* c), (EvaluateDiscreteStates)(EnterContinuousTimeMode))
FMI_REFUSED((void* c, bool*, bool*, bool*, bool*, bool*, double*), (UpdateDiscreteStates))
FMI_REFUSED((void* c, bool, bool*, bool*), (CompletedIntegratorStep))
FMI_REFUSED((void* c, double), (SetTime))
FMI_REFUSED((void* c, const double[], std::size_t), (SetContinuousStates))
FMI_REFUSED((void* c, double[], std::size_t), (GetContinuousStates)(GetContinuousStateDerivatives))
FMI_REFUSED((void* c, double[], std::size_t), (GetNominalsOfContinuousStates)(GetEventIndicators))
FMI_REFUSED((void* c, std::size_t*), (GetNumberOfContinuousStates)(GetNumberOfEventIndicators))
FMI_REFUSED((void* c, fmiReference, std::size_t*), (GetNumberOfVariableDependencies))
FMI_REFUSED((void* c, fmiReference, std::size_t[], fmiReference[], std::size_t[], fmi3Enum[], std::size_t),
            (GetVariableDependencies))
FMI_REFUSED((FMI_DERIVATIVE, std::size_t, double[], std::size_t), (GetDirectionalDerivative)(GetAdjointDerivative))
FMI_REFUSED((FMI_LIST, const std::int32_t[], double[], std::size_t), (GetOutputDerivatives))
FMI_REFUSED((FMI_LIST, double[], fmi3Enum[]), (GetIntervalDecimal))
FMI_REFUSED((FMI_LIST, std::uint64_t[], std::uint64_t[], fmi3Enum[]), (GetIntervalFraction))
FMI_REFUSED((FMI_LIST, double[]), (GetShiftDecimal))
FMI_REFUSED((FMI_LIST, std::uint64_t[], std::uint64_t[]), (GetShiftFraction))
FMI_REFUSED((FMI_LIST, const double[]), (SetIntervalDecimal)(SetShiftDecimal))
FMI_REFUSED((FMI_LIST, const std::uint64_t[], const std::uint64_t[]), (SetIntervalFraction)(SetShiftFraction))
FMI_REFUSED((void* c, fmiReference, double), (ActivateModelPartition))
#undef FMI_REFUSED
#undef FMI_REFUSE
#undef FMI_DERIVATIVE
#undef FMI_LIST
