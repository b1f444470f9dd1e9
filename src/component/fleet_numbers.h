// How the numbers of a fleet lie in memory, and a block of a log that is the same for all its components.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "rubber_suspension/component/fleet.h"

namespace rubber_suspension::component {

constexpr std::size_t kLanes = sizeof(LaneRow) / sizeof(double);

// Rows of a group. The friction's memory is in the order of BergFriction's; after it three rows per Maxwell element.
enum FleetRow : std::size_t {
  kDisplacement,
  kSpring,
  kDashpot,
  kMaximumForce,
  kCompliance,
  kDeadBand,
  kReferenceDisplacement,
  kReferenceForce,
  kExtremum,
  kDirection,
  kFirstMaxwell
};
constexpr std::size_t kMostMaxwells = 8;  // whose numbers stay in registers while a log is simulated

enum MaxwellRow : std::size_t { kDecay, kGain, kForce, kMaxwellRows };

/// Groups of eight components each, one after the other.
struct FleetGroups {
  LaneRow* first;
  std::size_t count;
  std::size_t rows;  ///< of each
  std::size_t maxwells;
  bool frictional;
};

/// Samples of a log during which friction stays on one branch, and on one side of its reference point.
struct Stretch {
  std::size_t end;       ///< sample after the last one
  double side;           ///< sign of the way from the reference point
  bool turns;            ///< whether a branch begins
  double turning_point;  ///< then: the displacement where
};

/// Samples of a log that is the same for all components.
struct LogBlock {
  static constexpr std::size_t kMost = 256;

  const double* displacement;
  std::size_t size;
  double increment[kMost];
  double way[kMost];  ///< from the reference point, without its sign
  Stretch stretch[kMost];
  double extremum = 0.0;  ///< at the end
  double direction = 0.0;

  LogBlock(const double* path, std::size_t count, double before) : displacement(path), size(count) {
    increment[0] = path[0] - before;
    for (std::size_t i = 1; i < count; ++i) {
      increment[i] = path[i] - path[i - 1];
    }
    stretch[0] = {count, 1.0, false, 0.0};
  }

  /// Fills in what friction needs, from an element of friction whose motion is that of all, and from its group.
  void findStretches(const element::BergFriction& berg, const LaneRow* group) {
    std::array<double, element::BergFriction::kMemorySize> memory{};
    for (std::size_t k = 0; k < memory.size(); ++k) {
      memory[k] = group[kReferenceDisplacement + k].lane[0];
    }
    Stretch* next = stretch;
    for (std::size_t i = 0; i < size;) {
      const double turning_point = memory[element::BergFriction::kExtremum];
      std::size_t end = i + berg.followUntilReversal(displacement + i, size - i, memory.data());
      const bool turns = end == i;
      if (turns) {
        berg.advance(displacement[i], memory.data());
        end = i + 1 + berg.followUntilReversal(displacement + i + 1, size - i - 1, memory.data());
      }
      bool begins = turns;
      while (i < end) {
        *next++ = sameSide(i, end, memory[element::BergFriction::kReferenceDisplacement]);
        next[-1].turns = begins;
        next[-1].turning_point = turning_point;
        begins = false;
        i = next[-1].end;
      }
    }
    extremum = memory[element::BergFriction::kExtremum];
    direction = memory[element::BergFriction::kDirection];
  }

 private:
  /// The samples from `first` on, up to `end`, that are on one side of the reference point.
  Stretch sameSide(std::size_t first, std::size_t end, double reference) {
    const bool below = std::signbit(displacement[first] - reference);
    std::size_t i = first;
    for (; i < end && std::signbit(displacement[i] - reference) == below; ++i) {
      way[i] = std::abs(displacement[i] - reference);
    }
    return {i, below ? -1.0 : 1.0, false, 0.0};
  }
};

}  // namespace rubber_suspension::component
