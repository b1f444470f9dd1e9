// Loads the live diagnosis.
#include "ros_interface/live_diagnoser.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace rubber_suspension::ros_interface {
namespace {

constexpr const char* kLibrary = "librubber_suspension_live.so";
constexpr const char* kMaker = "rubber_suspension_make_live_diagnoser";

[[noreturn]] void refuseLibrary() {
  throw std::runtime_error(fmt::format(
      "the parameter ~diagnose is true, but the diagnosis cannot be loaded: {}; accepted: an installation with {}",
      dlerror(), kLibrary));
}

}  // namespace

// It stays loaded: its code may still be at work when the process ends.
std::unique_ptr<LiveDiagnoser> loadLiveDiagnoser(ros::NodeHandle& handle,
                                                 const std::vector<node::ComponentChannel*>& channels,
                                                 const LiveDiagnoserSettings& settings) {
  void* const library = dlopen(kLibrary, RTLD_NOW);
  void* const maker = library == nullptr ? nullptr : dlsym(library, kMaker);
  if (maker == nullptr) {
    refuseLibrary();
  }
  using Make =
      LiveDiagnoser* (*)(ros::NodeHandle&, const std::vector<node::ComponentChannel*>&, const LiveDiagnoserSettings&);
  return std::unique_ptr<LiveDiagnoser>(reinterpret_cast<Make>(maker)(handle, channels, settings));
}

}  // namespace rubber_suspension::ros_interface
