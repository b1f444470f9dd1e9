// Each law keeps its force while the displacement is held and the displacement sensor is noisy.
#include "diagnosis/effect.h"
#include "gap/simulate.h"
#include "rubber_suspension/log/record.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

constexpr double kHeldStep = 1e-3;     // [s]
constexpr double kHeldAt = 2e-3;       // [m]
constexpr double kHeldNoise = 1e-6;    // standard deviation [m]
constexpr double kSpringBeside = 1e6;  // spring beside each law [N/m]
constexpr Eigen::Index kHeldSamples = 10000;

// Returns a record with a ramp to 2 mm within 1.5 s and a hold until 10 s.
log::Record held() {
  log::Record record;
  record.dt = kHeldStep;
  record.displacement =
      (Eigen::ArrayXd::LinSpaced(kHeldSamples, 0.0, kHeldStep * (kHeldSamples - 1)) / 1.5).min(1.0) * kHeldAt;
  record.raw_displacement = record.displacement;
  std::mt19937 generator(1);
  std::normal_distribution<double> normal(0.0, kHeldNoise);
  for (double& value : record.raw_displacement) {
    value += normal(generator);
  }
  record.force = kSpringBeside * record.displacement;
  return record;
}

// Returns the mean force in the 0.5 s after a time [s].
double meanAt(const Eigen::VectorXd& force, double time) {
  return force.segment(static_cast<Eigen::Index>(time / kHeldStep), kHeldSamples / 20).mean();
}

fit::Excitation excitation() {
  fit::Excitation result;
  result.largest_displacement = 2e-3;
  result.stiffness = kSpringBeside;
  result.force = 1e3;
  result.power = 20.0;
  result.highest_frequency = 15.0;
  result.mean_frequency = 5.0;
  result.highest_rate = 0.05;
  result.longest_duration = 20.0;
  result.slowest_loop = 1.0;
  result.dt = kHeldStep;
  result.whole_logs = 2;
  result.dead_band = 10.0 * kHeldNoise;
  result.has_temperature = true;
  result.lowest_temperature = 20.0;
  result.highest_temperature = 40.0;
  result.largest_radius = 4e-3;
  return result;
}

// Sensor noise reduces the force of a law when a hold begins; during the hold the loss must not grow. The tolerance is
// 2 % of the force of the law plus 5 standard deviations of the difference of two means of 500 noisy samples.
TEST(HeldDisplacement, KeepsTheForceOfAnyLawThatIsWritten) {
  const log::Record record = held();
  for (const fit::Candidate& candidate : diagnosis::candidates(excitation())) {
    const auto curved = candidate.along ? candidate.along({2.0, 0.0}) : std::vector<fit::BasisTerm>();
    for (const auto* laws : {&candidate.terms, &candidate.laws, &curved}) {
      for (const fit::BasisTerm& law : *laws) {
        const std::vector<element::ElementDescription> elements = {spring(kSpringBeside), law.at(law.typical)};
        const Eigen::VectorXd clean = gap::simulate(elements, {record})[0];
        const Eigen::VectorXd taken = clean - gap::simulate(elements, {record}, gap::asRecorded)[0];
        const double own = law.softening ? law.typical * kSpringBeside * kHeldAt
                                         : std::max(std::abs(meanAt(clean, 2.0) - kSpringBeside * kHeldAt),
                                                    std::abs(meanAt(clean, 9.0) - kSpringBeside * kHeldAt));
        const double noise = 5.0 * 1.2 * kSpringBeside * kHeldNoise * std::sqrt(2.0 / 500.0);
        EXPECT_NEAR(meanAt(taken, 9.0), meanAt(taken, 2.0), 0.02 * own + noise)
            << candidate.effect << ": " << elements[1].type << " of " << own << " N";
      }
    }
  }
}

}  // namespace
}  // namespace rubber_suspension
