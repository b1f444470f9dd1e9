// Branches of Berg friction along a log, from the memory of the element itself.
#include "fit/friction_path.h"

#include <array>
#include <cmath>

#include "rubber_suspension/element/berg_friction.h"

namespace rubber_suspension::fit {
namespace {

constexpr std::size_t kPadding = 8;  // of the widest vector

double sideOf(double travel) { return std::signbit(travel) ? -1.0 : 1.0; }

}  // namespace

FrictionPath::FrictionPath(const std::vector<double>& displacement, double dead_band) {
  using Slot = element::BergFriction::Slot;
  const element::BergFriction berg(1.0, 1.0, dead_band);
  std::array<double, Slot::kMemorySize> memory{};
  berg.initialise(displacement.front(), memory.data());
  travel_.reserve(displacement.size() + kPadding);
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const double reference = memory[Slot::kReferenceDisplacement];
    const double direction = memory[Slot::kDirection];
    berg.advance(displacement[i], memory.data());
    const bool reverses = direction != 0.0 && memory[Slot::kDirection] != direction;
    const double travel = displacement[i] - memory[Slot::kReferenceDisplacement];
    if (reverses || stretches_.empty() || stretches_.back().side != sideOf(travel)) {
      const double reversal_travel = reverses ? memory[Slot::kReferenceDisplacement] - reference : 0.0;
      stretches_.push_back({i, sideOf(travel), reverses, std::abs(reversal_travel), sideOf(reversal_travel)});
    }
    stretches_.back().end = i + 1;
    travel_.push_back(std::abs(travel));
  }
  travel_.resize(displacement.size() + kPadding, 0.0);
}

}  // namespace rubber_suspension::fit
