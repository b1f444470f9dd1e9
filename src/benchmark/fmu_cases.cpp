// A component through its FMU, as an importer drives it, against the component itself.
#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/force_case.h"
#include "fmi/export.h"
#include "fmi/runtime/fmi.h"

namespace rubber_suspension::benchmark {
namespace {

std::string binaryOf(const io::ComponentDescription& description) {
  for (fmi::ArchiveEntry& file : fmi::fmuFiles(description, fmi::Version::fmi2, fmi::installedParts())) {
    if (file.path.compare(0, 9, "binaries/") == 0) {
      return file.content;
    }
  }
  throw std::runtime_error("an FMU without a binary");
}

// The binary of an FMU, loaded from a file in memory.
class Binary {
 public:
  explicit Binary(const std::string& content) {
    const int file = memfd_create("fmu", 0);
    if (file < 0 || write(file, content.data(), content.size()) != static_cast<ssize_t>(content.size())) {
      throw std::runtime_error("no memory for the binary of an FMU");
    }
    library_ = dlopen(fmt::format("/proc/self/fd/{}", file).c_str(), RTLD_NOW | RTLD_LOCAL);
    close(file);
    if (library_ == nullptr) {
      throw std::runtime_error(dlerror());
    }
  }
  Binary(const Binary&) = delete;
  Binary& operator=(const Binary&) = delete;
  ~Binary() { dlclose(library_); }

  template <class Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(dlsym(library_, name));
  }

 private:
  void* library_;
};

struct FmuBench {
  io::ComponentDescription description{"bench", elementsOf(bareParameters(5))};
  component::Component component = description.makeComponent();
  std::vector<double> displacement;
  std::vector<double> bare;
  std::vector<double> library;
  Binary binary{binaryOf(description)};
  decltype(fmi2SetReal)* set = binary.function<decltype(fmi2SetReal)>("fmi2SetReal");
  decltype(fmi2GetReal)* get = binary.function<decltype(fmi2GetReal)>("fmi2GetReal");
  decltype(fmi2DoStep)* step = binary.function<decltype(fmi2DoStep)>("fmi2DoStep");

  const fmi2CallbackFunctions callbacks{};
  std::unique_ptr<void, decltype(fmi2FreeInstance)*> instance{
      binary.function<decltype(fmi2Instantiate)>("fmi2Instantiate")(
          "bench", fmi2CoSimulation, fmi::dataOf(description).guid.c_str(), "", &callbacks, 0, 0),
      binary.function<decltype(fmi2FreeInstance)>("fmi2FreeInstance")};

  explicit FmuBench(std::size_t samples)
      : displacement(benchmarkDisplacement(samples)), bare(samples), library(samples) {}

  void stepComponent() {
    component::ComponentState state = component.makeState();
    bare[0] = component.initialise(state, displacement[0]).total;
    for (std::size_t i = 1; i < displacement.size(); ++i) {
      bare[i] = component.step(state, kStep, displacement[i]).total;
    }
  }

  void stepFmu() {
    void* const fmu = instance.get();
    binary.function<decltype(fmi2Reset)>("fmi2Reset")(fmu);
    const fmi::Reference in = fmi::reference::kDisplacement;
    const fmi::Reference out = fmi::reference::kForce;
    binary.function<decltype(fmi2EnterInitializationMode)>("fmi2EnterInitializationMode")(fmu);
    set(fmu, &in, 1, displacement.data());
    binary.function<decltype(fmi2ExitInitializationMode)>("fmi2ExitInitializationMode")(fmu);
    get(fmu, &out, 1, library.data());
    double time = 0.0;
    for (std::size_t i = 1; i < displacement.size(); ++i, time += kStep) {
      set(fmu, &in, 1, &displacement[i]);
      step(fmu, time, kStep, 1);
      get(fmu, &out, 1, &library[i]);
    }
  }
};

}  // namespace

std::vector<Case> fmuCases(const BenchmarkSize& size) {
  Case result =
      forceCase(std::make_shared<FmuBench>(size.samples), "an FMU: `fmi2SetReal`, `fmi2DoStep`, `fmi2GetReal`",
                &FmuBench::stepFmu, "`Component::step`, constant dt", &FmuBench::stepComponent);
  result.tolerance = 0.0;  // the same bits
  return {result};
}

}  // namespace rubber_suspension::benchmark
