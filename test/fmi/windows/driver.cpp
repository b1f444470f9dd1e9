// Steps the binary of an FMU with one direction as an importer does, on Linux or Windows. It knows only the value
// references of displacement and force, which are arguments.
// Usage: driver BINARY VERSION TOKEN DISPLACEMENT FORCE STOP < LOG. Each line of the log is a time and a displacement.
// The program prints a force per line, and then the status of a step past the stop time.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>
#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace {

struct Callbacks2 {
  void (*logger)(void*, const char*, int, const char*, const char*, ...);
  void* (*allocate)(std::size_t, std::size_t);
  void (*release)(void*);
  void (*step_finished)(void*, int);
  void* environment;
};

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "driver: %s\n", what.c_str());
  std::exit(1);
}

void tell(void*, const char*, int, const char*, const char* message, ...) {
  std::fprintf(stderr, "fmu: %s\n", message);
}
void tell3(void*, int, const char*, const char* message) { std::fprintf(stderr, "fmu: %s\n", message); }

template <class Function>
Function* symbol(const char* binary, const char* name) {
#ifdef _WIN32
  static HMODULE library = LoadLibraryA(binary);
  void* found = library == nullptr ? nullptr : reinterpret_cast<void*>(GetProcAddress(library, name));
#else
  static void* library = dlopen(binary, RTLD_NOW | RTLD_LOCAL);
  void* found = library == nullptr ? nullptr : dlsym(library, name);
#endif
  if (found == nullptr) {
    fail(std::string(binary) + ": " + name + " cannot be loaded");
  }
  return reinterpret_cast<Function*>(found);
}

void require(int status, const char* call) {
  if (status != 0) {
    fail(std::string(call) + ": status " + std::to_string(status));
  }
}

// Calls the functions that both versions of the standard have, by name and with the arguments of each version.
class Fmu {
 public:
  Fmu(const char* binary, bool is_3, const char* token) : binary_(binary), is_3_(is_3) {
    static Callbacks2 callbacks = {tell, std::calloc, std::free, nullptr, nullptr};
    instance_ = is_3 ? symbol<void*(const char*, const char*, const char*, bool, bool, bool, bool, const std::uint32_t*,
                                    std::size_t, void*, void (*)(void*, int, const char*, const char*), void (*)())>(
                           binary, "fmi3InstantiateCoSimulation")("driver", token, "", false, false, false, false,
                                                                  nullptr, 0, nullptr, tell3, nullptr)
                     : symbol<void*(const char*, int, const char*, const char*, const Callbacks2*, int, int)>(
                           binary, "fmi2Instantiate")("driver", 1, token, "", &callbacks, 0, 0);
    if (instance_ == nullptr) {
      fail("no instance");
    }
  }

  void begin(double start, double stop) {
    if (is_3_) {
      require(symbol<int(void*, bool, double, double, bool, double)>(binary_, "fmi3EnterInitializationMode")(
                  instance_, false, 0.0, start, true, stop),
              "enter");
    } else {
      require(symbol<int(void*, int, double, double, int, double)>(binary_, "fmi2SetupExperiment")(instance_, 0, 0.0,
                                                                                                   start, 1, stop),
              "setup");
      require(symbol<int(void*)>(binary_, "fmi2EnterInitializationMode")(instance_), "enter");
    }
  }
  void ready() {
    require(symbol<int(void*)>(binary_, is_3_ ? "fmi3ExitInitializationMode" : "fmi2ExitInitializationMode")(instance_),
            "exit");
  }
  void set(std::uint32_t reference, double value) {
    require(is_3_ ? symbol<int(void*, const std::uint32_t*, std::size_t, const double*, std::size_t)>(
                        binary_, "fmi3SetFloat64")(instance_, &reference, 1, &value, 1)
                  : symbol<int(void*, const std::uint32_t*, std::size_t, const double*)>(binary_, "fmi2SetReal")(
                        instance_, &reference, 1, &value),
            "set");
  }
  double get(std::uint32_t reference) {
    double value = 0.0;
    require(is_3_ ? symbol<int(void*, const std::uint32_t*, std::size_t, double*, std::size_t)>(
                        binary_, "fmi3GetFloat64")(instance_, &reference, 1, &value, 1)
                  : symbol<int(void*, const std::uint32_t*, std::size_t, double*)>(binary_, "fmi2GetReal")(
                        instance_, &reference, 1, &value),
            "get");
    return value;
  }
  int step(double time, double size) {
    bool event = false;
    bool end = false;
    bool early = false;
    double last = 0.0;
    return is_3_ ? symbol<int(void*, double, double, bool, bool*, bool*, bool*, double*)>(binary_, "fmi3DoStep")(
                       instance_, time, size, true, &event, &end, &early, &last)
                 : symbol<int(void*, double, double, int)>(binary_, "fmi2DoStep")(instance_, time, size, 1);
  }
  void free() { symbol<void(void*)>(binary_, is_3_ ? "fmi3FreeInstance" : "fmi2FreeInstance")(instance_); }

 private:
  const char* binary_;
  bool is_3_;
  void* instance_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 7) {
    fail("wrong number of arguments");
  }
  const auto displacement = static_cast<std::uint32_t>(std::atoi(argv[4]));
  const auto force = static_cast<std::uint32_t>(std::atoi(argv[5]));
  const double stop = std::atof(argv[6]);
  std::vector<double> times;
  std::vector<double> values;
  for (double time = 0.0, value = 0.0; std::scanf("%lf %lf", &time, &value) == 2;) {
    times.push_back(time);
    values.push_back(value);
  }
  Fmu fmu(argv[1], argv[2][0] == '3', argv[3]);
  fmu.begin(times.at(0), stop);
  fmu.set(displacement, values.at(0));
  fmu.ready();
  std::printf("%.17g\n", fmu.get(force));
  for (std::size_t i = 1; i < times.size(); ++i) {
    fmu.set(displacement, values[i]);
    require(fmu.step(times[i - 1], times[i] - times[i - 1]), "step");
    std::printf("%.17g\n", fmu.get(force));
  }
  std::printf("%d\n", fmu.step(times.back(), stop - times.back() + 0.1));
  fmu.free();
  return 0;
}
