// A component through its FMU, as an importer drives it, against the component itself.
#include <memory>

#include "benchmark/cases.h"

#ifdef RUBBER_SUSPENSION_WITH_FMU
#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include "benchmark/bare_loop.h"
#include "benchmark/test_signal.h"
#include "fmi/archive.h"
#include "fmi/export.h"
#include "fmi/runtime/fmi2.h"
#endif

namespace rubber_suspension::benchmark {

#ifdef RUBBER_SUSPENSION_WITH_FMU
namespace {

constexpr int kMaxwellElements = 5;

// The binary of an FMU, loaded from a file that is gone at once.
class Binary {
 public:
  explicit Binary(const std::string& content) {
    std::string path = "/tmp/rubber_suspension.XXXXXX";
    const int file = mkstemp(path.data());
    if (file < 0) {
      throw std::runtime_error(path + ": cannot be made");
    }
    close(file);
    std::ofstream(path, std::ios::binary) << content;
    library_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    unlink(path.c_str());
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

std::string binaryOf(const io::ComponentDescription& description) {
  for (fmi::ArchiveEntry& entry :
       fmi::fromZip(fmi::makeFmu(description, fmi::Version::fmi2, fmi::installedParts()), "FMU")) {
    if (entry.path.compare(0, 9, "binaries/") == 0) {
      return entry.content;
    }
  }
  throw std::runtime_error("an FMU without a binary");
}

struct FmuBench {
  io::ComponentDescription description{"bench", elementsOf(bareParameters(kMaxwellElements))};
  component::Component component = description.makeComponent();
  std::vector<double> displacement;
  std::vector<double> bare;
  std::vector<double> library;
  Binary binary{binaryOf(description)};
  fmi2Component instance = nullptr;
  decltype(fmi2SetReal)* set = binary.function<decltype(fmi2SetReal)>("fmi2SetReal");
  decltype(fmi2GetReal)* get = binary.function<decltype(fmi2GetReal)>("fmi2GetReal");
  decltype(fmi2DoStep)* step = binary.function<decltype(fmi2DoStep)>("fmi2DoStep");

  explicit FmuBench(std::size_t samples)
      : displacement(benchmarkDisplacement(samples)), bare(samples), library(samples) {
    const fmi2CallbackFunctions callbacks{};
    instance = binary.function<decltype(fmi2Instantiate)>("fmi2Instantiate")(
        "bench", fmi2CoSimulation, fmi::dataOf(description).guid.c_str(), "", &callbacks, 0, 0);
    if (instance == nullptr) {
      throw std::runtime_error("no instance of the FMU");
    }
  }
  FmuBench(const FmuBench&) = delete;
  FmuBench& operator=(const FmuBench&) = delete;
  ~FmuBench() { binary.function<decltype(fmi2FreeInstance)>("fmi2FreeInstance")(instance); }

  void stepComponent() {
    component::ComponentState state = component.makeState();
    bare[0] = component.initialise(state, displacement[0]).total;
    for (std::size_t i = 1; i < displacement.size(); ++i) {
      bare[i] = component.step(state, kStep, displacement[i]).total;
    }
  }

  void stepFmu() {
    const fmi2ValueReference in = fmi::reference::kDisplacement;
    const fmi2ValueReference out = fmi::reference::kForce;
    binary.function<decltype(fmi2Reset)>("fmi2Reset")(instance);
    binary.function<decltype(fmi2EnterInitializationMode)>("fmi2EnterInitializationMode")(instance);
    set(instance, &in, 1, displacement.data());
    binary.function<decltype(fmi2ExitInitializationMode)>("fmi2ExitInitializationMode")(instance);
    get(instance, &out, 1, library.data());
    double time = 0.0;
    for (std::size_t i = 1; i < displacement.size(); ++i, time += kStep) {
      set(instance, &in, 1, &displacement[i]);
      step(instance, time, kStep, 1);
      get(instance, &out, 1, &library[i]);
    }
  }
};

}  // namespace
#endif

std::vector<Case> fmuCases([[maybe_unused]] const BenchmarkSize& size) {
  std::vector<Case> cases;
#ifdef RUBBER_SUSPENSION_WITH_FMU
  const auto bench = std::make_shared<FmuBench>(size.samples);
  Case result;
  result.name = "an FMU: `fmi2SetReal`, `fmi2DoStep`, `fmi2GetReal`";
  result.baseline = "`Component::step`, constant dt";
  result.unit = "step";
  result.count = result.baseline_count = static_cast<double>(size.samples);
  result.bare = [bench] { bench->stepComponent(); };
  result.library = [bench] { bench->stepFmu(); };
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  result.tolerance = 0.0;  // the same bits
  cases.push_back(result);
#endif
  return cases;
}

}  // namespace rubber_suspension::benchmark
