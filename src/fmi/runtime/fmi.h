// The C interfaces of FMI 2.0.4 and FMI 3.0 for co-simulation.
#pragma once

#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <cstddef>
#include <cstdint>

// The standards determine the names.
// NOLINTBEGIN
#pragma GCC visibility push(default)
extern "C" {

typedef std::uint32_t fmiReference;
typedef const char* fmiString;
typedef int fmi2Boolean;
typedef const std::uint8_t* fmi3Binary;
typedef int fmi3Enum;  // any enumeration in calls that this package does not support

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
typedef void (*fmi3Callback)();  // stands for callbacks with any arguments, because this package calls none of them

#ifdef _WIN32
#define FMI_EXPORT __declspec(dllexport)
#else
#define FMI_EXPORT
#endif
#define FMI_PLAIN(Result, name, parameters, ...) FMI_EXPORT Result name parameters;
#define FMI_CALL(V, name, parameters, ...) FMI_EXPORT fmi##V##Status fmi##V##name parameters;
#include "fmi/runtime/calls.h"
#undef FMI_CALL
#undef FMI_PLAIN

}  // extern "C"
#pragma GCC visibility pop
// NOLINTEND
