// Laws that may be written keep their force while the displacement is held and its sensor is noisy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "diagnosis/hypotheses/candidate/registry.h"
#include "gap/simulate.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension {
namespace {

constexpr double kStep = 1e-3;      // [s]
constexpr double kHeld = 2e-3;      // [m]
constexpr double kNoise = 1e-6;     // standard deviation [m]
constexpr double kStiffness = 1e6;  // of the spring beside each law [N/m]
constexpr Eigen::Index kSamples = 10000;

// Up to 2 mm within a second and a half, and from two seconds on held for eight.
log::Record held() {
  log::Record record;
  record.dt = kStep;
  record.displacement = (Eigen::ArrayXd::LinSpaced(kSamples, 0.0, kStep * (kSamples - 1)) / 1.5).min(1.0) * kHeld;
  record.raw_displacement = record.displacement;
  std::mt19937 generator(1);
  std::normal_distribution<double> normal(0.0, kNoise);
  for (double& value : record.raw_displacement) {
    value += normal(generator);
  }
  record.force = kStiffness * record.displacement;
  return record;
}

// About a time [s].
double meanAt(const Eigen::VectorXd& force, double time) {
  return force.segment(static_cast<Eigen::Index>(time / kStep), kSamples / 20).mean();
}

fit::Excitation excitation() {
  fit::Excitation result;
  result.largest_displacement = 2e-3;
  result.stiffness = kStiffness;
  result.force = 1e3;
  result.power = 20.0;
  result.highest_frequency = 15.0;
  result.mean_frequency = 5.0;
  result.highest_rate = 0.05;
  result.longest_duration = 20.0;
  result.slowest_loop = 1.0;
  result.dt = kStep;
  result.whole_logs = 2;
  result.dead_band = 10.0 * kNoise;
  result.has_temperature = true;
  result.lowest_temperature = 20.0;
  result.highest_temperature = 40.0;
  result.largest_radius = 4e-3;
  return result;
}

// What noise takes from a law while 2 mm are held is taken at once, by the largest of it, and no more later: but for 2
// % of what the law does, and the means of the noise of 500 samples on the spring and the law, of whose difference this
// is 5 standard deviations.
TEST(HeldDisplacement, KeepsTheForceOfAnyLawThatIsWritten) {
  const log::Record record = held();
  for (const fit::Candidate& candidate : diagnosis::hypotheses::candidate::candidates(excitation())) {
    for (const auto* laws : {&candidate.terms, &candidate.laws}) {
      for (const fit::BasisTerm& law : *laws) {
        const std::vector<element::ElementDescription> elements = {{"spring", {{"stiffness", {kStiffness}}}},
                                                                   law.at(law.typical)};
        const Eigen::VectorXd clean = gap::simulate(elements, {record})[0];
        const Eigen::VectorXd taken = clean - gap::simulate(elements, {record}, gap::asRecorded)[0];
        const double own = law.softening ? law.typical * kStiffness * kHeld
                                         : std::max(std::abs(meanAt(clean, 2.0) - kStiffness * kHeld),
                                                    std::abs(meanAt(clean, 9.0) - kStiffness * kHeld));
        const double noise = 5.0 * 1.2 * kStiffness * kNoise * std::sqrt(2.0 / 500.0);
        EXPECT_NEAR(meanAt(taken, 9.0), meanAt(taken, 2.0), 0.02 * own + noise)
            << candidate.effect << ": " << elements[1].type << " of " << own << " N";
      }
    }
  }
}

}  // namespace
}  // namespace rubber_suspension
