// Creep: force that relaxes by the same amount in every decade of time under a hold.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "element/maxwell_bank.h"
#include "element/registry.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::element {
namespace {

constexpr double kElementsPerDecade = 2.0;
constexpr double kMaximumDecadesOfTime = 12.0;  // bounds the memory

/// Returns Maxwell elements whose force after a step of displacement z falls by S z per decade of time, between the
/// shortest and the longest time. There are about two elements per decade, of equal stiffness S/2. Their relaxation
/// times are the centres of equal bands on a logarithmic axis, so the slope ripples by less than 0.5 % far from both
/// times. Right after the step the force is S z for each decade, so the elements also stiffen motion that is faster
/// than the shortest time. Validity: times between the two. The force is constant before the shortest and after the
/// longest time. Towards the longest time T the slope falls as exp(-t/T), by 10 % at T/10. Source: A. N. Gent, J. Appl.
/// Polym. Sci. 6 (1962) 433-441 (stress relaxation linear in log t).
std::vector<Maxwell> creepBank(double stiffness_per_decade /* S [N/m] */, double shortest_time /* [s] */,
                               double longest_time /* [s] */) {
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
                fmt::format("in ({:g}, {:g}], which is at most {:g} decades above shortest_time", shortest, most,
                            kMaximumDecadesOfTime));
  }
}

const ElementEntry kCreepEntry(
    210, {"creep",
          "Slow relaxation: while the displacement is held, the force falls linearly with log t.",
          {{"stiffness_per_decade", "N/m", Role::scale, Range::positive(),
            "fall of the force per displacement and decade of time"},
           {"shortest_time", "s", Role::choice, Range::positive(), "time at which the relaxation begins", 1.0},
           {"longest_time", "s", Role::choice, Range::positive(), "time at which the relaxation ends", 10000.0}},
          [](const ElementDescription& description) -> ElementPointer {
            checkTimes(description);
            return std::make_shared<const MaxwellBank>(creepBank(description.value("stiffness_per_decade"),
                                                                 description.value("shortest_time"),
                                                                 description.value("longest_time")));
          }});

}  // namespace
}  // namespace rubber_suspension::element
