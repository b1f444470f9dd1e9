// The C interface of FMI 3.0 for co-simulation, as the standard describes it (FMI 3.0, chapters 2 and 4).
#pragma once

#include <cstddef>
#include <cstdint>

// The names are those of the standard.
// NOLINTBEGIN
#pragma GCC visibility push(default)
extern "C" {

typedef void* fmi3Instance;
typedef void* fmi3InstanceEnvironment;
typedef void* fmi3FMUState;
typedef std::uint32_t fmi3ValueReference;
typedef float fmi3Float32;
typedef double fmi3Float64;
typedef std::int8_t fmi3Int8;
typedef std::uint8_t fmi3UInt8;
typedef std::int16_t fmi3Int16;
typedef std::uint16_t fmi3UInt16;
typedef std::int32_t fmi3Int32;
typedef std::uint32_t fmi3UInt32;
typedef std::int64_t fmi3Int64;
typedef std::uint64_t fmi3UInt64;
typedef bool fmi3Boolean;
typedef const char* fmi3String;
typedef std::uint8_t fmi3Byte;
typedef const fmi3Byte* fmi3Binary;
typedef bool fmi3Clock;

enum fmi3Status { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal };
enum fmi3DependencyKind { fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent };
enum fmi3IntervalQualifier { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged };

typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String category, fmi3String message);
typedef void (*fmi3ClockUpdateCallback)(fmi3InstanceEnvironment);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment, fmi3Float64 time, fmi3Boolean set_requested,
                                               fmi3Boolean get_allowed, fmi3Boolean step_finished,
                                               fmi3Boolean can_return_early, fmi3Boolean* early_return_requested,
                                               fmi3Float64* early_return_time);
typedef void (*fmi3LockPreemptionCallback)();
typedef void (*fmi3UnlockPreemptionCallback)();

const char* fmi3GetVersion();
fmi3Status fmi3SetDebugLogging(fmi3Instance, fmi3Boolean on, std::size_t count, const fmi3String categories[]);
fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean logging_on, fmi3InstanceEnvironment, fmi3LogMessageCallback);
fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging_on, fmi3Boolean event_mode_used,
                                         fmi3Boolean early_return_allowed,
                                         const fmi3ValueReference required_intermediate_variables[], std::size_t,
                                         fmi3InstanceEnvironment, fmi3LogMessageCallback,
                                         fmi3IntermediateUpdateCallback);
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging_on, fmi3InstanceEnvironment,
                                               fmi3LogMessageCallback, fmi3ClockUpdateCallback,
                                               fmi3LockPreemptionCallback, fmi3UnlockPreemptionCallback);
void fmi3FreeInstance(fmi3Instance);
fmi3Status fmi3EnterInitializationMode(fmi3Instance, fmi3Boolean tolerance_defined, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean stop_defined, fmi3Float64 stop);
fmi3Status fmi3ExitInitializationMode(fmi3Instance);
fmi3Status fmi3EnterEventMode(fmi3Instance);
fmi3Status fmi3Terminate(fmi3Instance);
fmi3Status fmi3Reset(fmi3Instance);

fmi3Status fmi3GetFloat64(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Float64[], std::size_t);
fmi3Status fmi3SetFloat64(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Float64[], std::size_t);
fmi3Status fmi3GetFloat32(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Float32[], std::size_t);
fmi3Status fmi3SetFloat32(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Float32[], std::size_t);
fmi3Status fmi3GetInt8(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Int8[], std::size_t);
fmi3Status fmi3SetInt8(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Int8[], std::size_t);
fmi3Status fmi3GetUInt8(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3UInt8[], std::size_t);
fmi3Status fmi3SetUInt8(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3UInt8[], std::size_t);
fmi3Status fmi3GetInt16(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Int16[], std::size_t);
fmi3Status fmi3SetInt16(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Int16[], std::size_t);
fmi3Status fmi3GetUInt16(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3UInt16[], std::size_t);
fmi3Status fmi3SetUInt16(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3UInt16[], std::size_t);
fmi3Status fmi3GetInt32(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Int32[], std::size_t);
fmi3Status fmi3SetInt32(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Int32[], std::size_t);
fmi3Status fmi3GetUInt32(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3UInt32[], std::size_t);
fmi3Status fmi3SetUInt32(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3UInt32[], std::size_t);
fmi3Status fmi3GetInt64(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Int64[], std::size_t);
fmi3Status fmi3SetInt64(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Int64[], std::size_t);
fmi3Status fmi3GetUInt64(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3UInt64[], std::size_t);
fmi3Status fmi3SetUInt64(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3UInt64[], std::size_t);
fmi3Status fmi3GetBoolean(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Boolean[], std::size_t);
fmi3Status fmi3SetBoolean(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Boolean[], std::size_t);
fmi3Status fmi3GetString(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3String[], std::size_t);
fmi3Status fmi3SetString(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3String[], std::size_t);
fmi3Status fmi3GetBinary(fmi3Instance, const fmi3ValueReference[], std::size_t, std::size_t[], fmi3Binary[],
                         std::size_t);
fmi3Status fmi3SetBinary(fmi3Instance, const fmi3ValueReference[], std::size_t, const std::size_t[], const fmi3Binary[],
                         std::size_t);
fmi3Status fmi3GetClock(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Clock[]);
fmi3Status fmi3SetClock(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Clock[]);

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance, fmi3ValueReference, std::size_t*);
fmi3Status fmi3GetVariableDependencies(fmi3Instance, fmi3ValueReference, std::size_t[], fmi3ValueReference[],
                                       std::size_t[], fmi3DependencyKind[], std::size_t);
fmi3Status fmi3GetFMUState(fmi3Instance, fmi3FMUState*);
fmi3Status fmi3SetFMUState(fmi3Instance, fmi3FMUState);
fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState*);
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance, fmi3FMUState, std::size_t*);
fmi3Status fmi3SerializeFMUState(fmi3Instance, fmi3FMUState, fmi3Byte[], std::size_t);
fmi3Status fmi3DeserializeFMUState(fmi3Instance, const fmi3Byte[], std::size_t, fmi3FMUState*);
fmi3Status fmi3GetDirectionalDerivative(fmi3Instance, const fmi3ValueReference[], std::size_t,
                                        const fmi3ValueReference[], std::size_t, const fmi3Float64[], std::size_t,
                                        fmi3Float64[], std::size_t);
fmi3Status fmi3GetAdjointDerivative(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3ValueReference[],
                                    std::size_t, const fmi3Float64[], std::size_t, fmi3Float64[], std::size_t);
fmi3Status fmi3EnterConfigurationMode(fmi3Instance);
fmi3Status fmi3ExitConfigurationMode(fmi3Instance);
fmi3Status fmi3GetIntervalDecimal(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Float64[],
                                  fmi3IntervalQualifier[]);
fmi3Status fmi3GetIntervalFraction(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3UInt64[], fmi3UInt64[],
                                   fmi3IntervalQualifier[]);
fmi3Status fmi3GetShiftDecimal(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3Float64[]);
fmi3Status fmi3GetShiftFraction(fmi3Instance, const fmi3ValueReference[], std::size_t, fmi3UInt64[], fmi3UInt64[]);
fmi3Status fmi3SetIntervalDecimal(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Float64[]);
fmi3Status fmi3SetIntervalFraction(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3UInt64[],
                                   const fmi3UInt64[]);
fmi3Status fmi3SetShiftDecimal(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Float64[]);
fmi3Status fmi3SetShiftFraction(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3UInt64[],
                                const fmi3UInt64[]);
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance);
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
                                    fmi3Float64*);

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance);
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance, fmi3Boolean, fmi3Boolean*, fmi3Boolean*);
fmi3Status fmi3SetTime(fmi3Instance, fmi3Float64);
fmi3Status fmi3SetContinuousStates(fmi3Instance, const fmi3Float64[], std::size_t);
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance, fmi3Float64[], std::size_t);
fmi3Status fmi3GetEventIndicators(fmi3Instance, fmi3Float64[], std::size_t);
fmi3Status fmi3GetContinuousStates(fmi3Instance, fmi3Float64[], std::size_t);
fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance, fmi3Float64[], std::size_t);
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance, std::size_t*);
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance, std::size_t*);

fmi3Status fmi3EnterStepMode(fmi3Instance);
fmi3Status fmi3GetOutputDerivatives(fmi3Instance, const fmi3ValueReference[], std::size_t, const fmi3Int32[],
                                    fmi3Float64[], std::size_t);
fmi3Status fmi3DoStep(fmi3Instance, fmi3Float64 time, fmi3Float64 size, fmi3Boolean no_return_before_this_time,
                      fmi3Boolean* event_needed, fmi3Boolean* terminate, fmi3Boolean* early_return,
                      fmi3Float64* last_successful_time);
fmi3Status fmi3ActivateModelPartition(fmi3Instance, fmi3ValueReference, fmi3Float64);

}  // extern "C"
#pragma GCC visibility pop
// NOLINTEND
