// Creep: force linear in the logarithm of time under a hold.
#include "rubber_suspension/element/creep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::element {
namespace {

constexpr double kElementsPerDecade = 2.0;
constexpr double kMaximumDecadesOfTime = 12.0;  // bounds the memory

std::vector<Maxwell> creepBank(double stiffness_per_decade, double shortest_time, double longest_time) {
  const double decades = std::log10(longest_time / shortest_time);
  const int count = std::max(1, static_cast<int>(std::lround(kElementsPerDecade * decades)));
  const double band = decades / count;
  std::vector<Maxwell> elements;
  for (int i = 0; i < count; ++i) {
    const double relaxation_time = shortest_time * std::pow(10.0, band * (i + 0.5));
    elements.emplace_back(stiffness_per_decade * band, 1.0 / (2.0 * kPi * relaxation_time));
  }
  return elements;
}

void checkTimes(const ElementDescription& description) {
  const double shortest = description.value("shortest_time");
  const double longest = description.value("longest_time");
  const double most = shortest * std::pow(10.0, kMaximumDecadesOfTime);
  if (!(longest > shortest && longest <= most)) {
    refuseValue(description.type, "longest_time", longest, "s",
                fmt::format("in ({:g}, {:g}], above shortest_time by {:g} decades at most", shortest, most,
                            kMaximumDecadesOfTime));
  }
}

}  // namespace

Creep::Creep(double stiffness_per_decade, double shortest_time, double longest_time)
    : MaxwellBank(creepBank(stiffness_per_decade, shortest_time, longest_time)) {}

ElementType creepType() {
  return {"creep",
          "Slow relaxation: the force under a hold falls linearly in log t.",
          {{"stiffness_per_decade", "N/m", Role::scale, Range::positive(),
            "fall of the force per displacement and decade of time"},
           {"shortest_time", "s", Role::choice, Range::positive(), "time at which the fall begins", 1.0},
           {"longest_time", "s", Role::choice, Range::positive(), "time at which it ends", 10000.0}},
          [](const ElementDescription& description) -> ElementPointer {
            checkTimes(description);
            return std::make_shared<const Creep>(description.value("stiffness_per_decade"),
                                                 description.value("shortest_time"), description.value("longest_time"));
          }};
}

}  // namespace rubber_suspension::element
