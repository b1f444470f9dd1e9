// The state of an FMU that an importer saves, to undo a step or to continue elsewhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::fmi {

/// Phase of an instance between instantiation and release.
enum class Phase : std::uint32_t { instantiated, initialising, stepping, terminated, failed };

/// Highest time derivative of the displacement that an importer may give for the next step.
constexpr std::size_t kMostDerivatives = 3;

/// Stop time [s] if the experiment defines none; no step reaches it.
constexpr double kNoStop = std::numeric_limits<double>::max();

/// Inputs or outputs: one displacement [m] and its force with the parts elastic, viscous and friction [N], or a pose
/// [m, rad] and a wrench [N, N m].
using Numbers = std::array<double, 6>;

/// State of an instance apart from its component.
struct Standing {
  Phase phase = Phase::instantiated;
  double time = 0.0;           ///< [s]
  double stop_time = kNoStop;  ///< [s]
  Numbers inputs = {};
  Numbers outputs = {};
  std::array<double, kMostDerivatives> derivative = {};  ///< of the input, first order at [0] [m/s, ...]
  bool has_temperature = false;                          ///< true if the input `temperature` was set
  double degrees = 0.0;                                  ///< the temperature [degC] if it was set
  std::vector<double> parameters;                        ///< values of the parameters that can be set
  bool settled = false;  ///< the component has been built and initialised; it may have been stepped since

  std::optional<double> temperature() const { return has_temperature ? std::optional(degrees) : std::nullopt; }
};

struct SavedState {
  std::uint64_t fingerprint = 0;  ///< fingerprint of the FMU
  Standing standing;
  double component_displacement = 0.0;  ///< displacement of the component [m]
  std::vector<double> memory;           ///< memory of the component
};

/// Returns bytes that preserve every number exactly and are the same on all computers with the same byte order.
std::string serialise(const SavedState& state);

/// Returns the state from bytes that serialise() has written. Throws std::exception for any other bytes.
SavedState deserialise(const char* bytes, std::size_t size);

/// Returns the hash of a GUID, which identifies an FMU (FNV-1a).
std::uint64_t fingerprintOf(const std::string& guid);

}  // namespace rubber_suspension::fmi
