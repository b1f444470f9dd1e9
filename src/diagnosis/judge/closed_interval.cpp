// Bootstrap of the closed fraction.
#include "diagnosis/judge/closed_interval.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace rubber_suspension::diagnosis {
namespace {

// Standard error of the logarithm of the noise floor: 95 of 100 estimates of virtual rigs lay between 0.74 and 2.2
// times their true floors.
constexpr double kFloorError = 0.3;

}  // namespace

std::array<double, 2> closedInterval(const std::vector<gap::PartError>& before,
                                     const std::vector<gap::PartError>& after, double floor, int resamplings,
                                     unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<std::size_t> pick(0, before.size() - 1);
  std::normal_distribution<double> floor_error(0.0, kFloorError);
  std::vector<double> fractions;
  for (int i = 0; i < resamplings; ++i) {
    std::vector<gap::PartError> a;
    std::vector<gap::PartError> b;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const std::size_t chosen = pick(generator);
      a.push_back(before[chosen]);
      b.push_back(after[chosen]);
    }
    const double gap_before = gap::gapOfParts(a);
    const double gap_after = gap::gapOfParts(b);
    // Noise is no more than what a model leaves.
    const double drawn = std::min({floor * std::exp(floor_error(generator)), gap_before, gap_after});
    fractions.push_back(gap::closedFraction(gap_before, gap_after, drawn));
  }
  std::sort(fractions.begin(), fractions.end());
  const auto at = [&](double share) {
    return fractions[static_cast<std::size_t>(share * static_cast<double>(fractions.size() - 1))];
  };
  return {at(0.025), at(0.975)};
}

}  // namespace rubber_suspension::diagnosis
