// The fluid of a hydraulic mount is identified from a log and from a table.
#include "fit/table_fit.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/fit/identification.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/response/sweep.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

const Entries kTruth = {spring(2e5), entry("inertia_track mass=60 damping=1500 stiffness=2.5e5")};
const Entries kGiven = {spring(3e5), entry("inertia_track mass=40 damping=2200 stiffness=1.8e5")};

/// Records 20 s of a sweep of 1 mm from 1 to 30 Hz, sampled at 500 Hz, with noise of 1 % of the force.
log::Log sweep() {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 3.0);
  log::Log log = logOf("sweep", 10000, 2000000, [](int i) {
    const double t = 0.002 * i;
    return 1e-3 * std::sin(2.0 * element::kPi * (1.0 + 0.725 * t) * t);
  });
  log.force = gap::simulateLog(component::Component(kTruth), log);
  for (double& force : log.force) {
    force += noise(random);
  }
  return log;
}

void expectTruth(const Entries& found, double accuracy) {
  ASSERT_EQ(found.size(), kTruth.size());
  EXPECT_NEAR(found[0].value("stiffness") / 2e5, 1.0, accuracy);
  for (const auto& [name, values] : kTruth[1].values) {
    EXPECT_NEAR(found[1].value(name) / values[0], 1.0, accuracy) << name;
  }
}

// Noise of 1 % averages to 1e-4 of the force over 10,000 samples. Correlated parameters have somewhat larger errors.
TEST(InertiaTrackFit, IsFoundInALog) {
  fit::IdentificationOptions options;
  options.starts = 4;
  expectTruth(fit::identify(kGiven, {sweep()}, options).elements, 5e-3);
}

TEST(InertiaTrackFit, IsFoundInATable) {
  const component::Component truth(kTruth);
  std::vector<fit::TablePoint> points;
  for (const double frequency : {1.0, 3.0, 6.0, 8.0, 10.0, 13.0, 18.0, 30.0}) {
    const auto found = response::characteristicsAt(truth, frequency, 5e-4).characteristics;
    points.push_back({frequency, 5e-4, found.stiffness, found.loss_angle});
  }
  expectTruth(fit::fitToTable({"mount", kGiven}, points).component.elements(), 1e-4);
}

}  // namespace
}  // namespace rubber_suspension
