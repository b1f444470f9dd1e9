// Branches of Berg friction along a log, from the memory of the element itself.
#include "fit/friction_path.h"

#include <array>
#include <cmath>

#include "rubber_suspension/element/berg_friction.h"

namespace rubber_suspension::fit {
namespace {

constexpr std::size_t kPadding = 8;  // of the widest vector

double sideOf(double way) { return std::signbit(way) ? -1.0 : 1.0; }

}  // namespace

FrictionPath::FrictionPath(const std::vector<double>& displacement, double dead_band) {
  using Slot = element::BergFriction::Slot;
  const element::BergFriction berg(1.0, 1.0, dead_band);
  std::array<double, Slot::kMemorySize> memory{};
  berg.initialise(displacement.front(), memory.data());
  way_.reserve(displacement.size() + kPadding);
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const double reference = memory[Slot::kReferenceDisplacement];
    const double direction = memory[Slot::kDirection];
    berg.advance(displacement[i], memory.data());
    const bool turns = direction != 0.0 && memory[Slot::kDirection] != direction;
    const double way = displacement[i] - memory[Slot::kReferenceDisplacement];
    if (turns || stretches_.empty() || stretches_.back().side != sideOf(way)) {
      const double turning_way = turns ? memory[Slot::kReferenceDisplacement] - reference : 0.0;
      stretches_.push_back({i, sideOf(way), turns, std::abs(turning_way), sideOf(turning_way)});
    }
    stretches_.back().end = i + 1;
    way_.push_back(std::abs(way));
  }
  way_.resize(displacement.size() + kPadding, 0.0);
}

}  // namespace rubber_suspension::fit
