// The C interfaces of FMI 2.0 and FMI 3.0 for co-simulation, as the standards describe them (FMI 2.0.4 and FMI 3.0,
// chapters 2 and 4).
#pragma once

#include <cstddef>
#include <cstdint>

// The names are those of the standards.
// NOLINTBEGIN
#pragma GCC visibility push(default)
extern "C" {

typedef std::uint32_t fmiReference;
typedef const char* fmiString;
typedef int fmi2Boolean;
typedef const std::uint8_t* fmi3Binary;
typedef int fmi3Enum;  // of whatever kind, in calls that are refused

enum fmi2Status { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending };
enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation };
enum fmi2StatusKind { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };
enum fmi3Status { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal };

struct fmi2CallbackFunctions {
  void (*logger)(void* environment, fmiString instance, fmi2Status, fmiString category, fmiString message, ...);
  void* (*allocateMemory)(std::size_t count, std::size_t size);
  void (*freeMemory)(void* block);
  void (*stepFinished)(void* environment, fmi2Status);
  void* componentEnvironment;
};
typedef void (*fmi3LogMessageCallback)(void* environment, fmi3Status, fmiString category, fmiString message);
typedef void (*fmi3Callback)();  // of whatever arguments: this package calls none

fmiString fmi2GetTypesPlatform();
fmiString fmi2GetVersion();
void* fmi2Instantiate(fmiString name, fmi2Type, fmiString guid, fmiString resources, const fmi2CallbackFunctions*,
                      fmi2Boolean visible, fmi2Boolean logging_on);
void fmi2FreeInstance(void*);

fmiString fmi3GetVersion();
void* fmi3InstantiateModelExchange(fmiString name, fmiString token, fmiString resources, bool visible, bool logging_on,
                                   void* environment, fmi3LogMessageCallback);
void* fmi3InstantiateCoSimulation(fmiString name, fmiString token, fmiString resources, bool visible, bool logging_on,
                                  bool event_mode_used, bool early_return_allowed, const fmiReference intermediate[],
                                  std::size_t, void* environment, fmi3LogMessageCallback, fmi3Callback update);
void* fmi3InstantiateScheduledExecution(fmiString name, fmiString token, fmiString resources, bool visible,
                                        bool logging_on, void* environment, fmi3LogMessageCallback,
                                        fmi3Callback clock_update, fmi3Callback lock, fmi3Callback unlock);
void fmi3FreeInstance(void*);

#define FMI_CALL(Status, name, parameters, ...) Status name parameters;
#include "fmi/runtime/calls.h"
#undef FMI_CALL

}  // extern "C"
#pragma GCC visibility pop
// NOLINTEND
