// Simulating a log in pieces, as large logs are read, gives the same forces as a single call.
#include "gap/log_driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gap/simulate.h"
#include "rubber_suspension/component/sample_stream.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

const Entries kDrivenLaws = {spring(3e6), maxwell(1.2e6, 2.0), friction(900.0, 4e-4),
                             entry("wlf_shift c1=6.13 c2=146.8 reference=20"),
                             entry("radial_stiffness quadratic=0 cubic=1e12 quintic=0 alone=0")};

log::Log recordedLog() {
  log::Log log = logOf(
      "log", 700, 2000000, [](int i) { return 1e-3 * std::sin(0.05 * i); },
      [](int /*i*/, double z) { return 3e6 * z; });
  for (int i = 0; i < 700; ++i) {
    log.temperature.push_back(10.0 + 0.01 * (i / 10));
  }
  return log;
}

// Simulates a record in pieces of at most `most` samples. `before` determines the initial state.
Eigen::VectorXd driven(gap::LogDriver& driver, const log::Record& record, Eigen::Index most, gap::Before before) {
  Eigen::VectorXd force(record.size());
  driver.begin(before, &record.lead_in);
  for (Eigen::Index first = 0; first < record.size(); first += most) {
    const auto size = static_cast<std::size_t>(std::min(most, record.size() - first));
    driver.drive({0.0, size, record.displacement.data() + first, nullptr, record.temperature.data() + first,
                  record.across.data() + first, nullptr},
                 record.dt, force.data() + first);
  }
  return force;
}

TEST(LogDriver, HasTheSameForcesPieceByPiece) {
  gap::PreparedRecord record = log::makeRecord(recordedLog());
  record.across = 5e-4 * record.displacement.array().square() / 1e-6;
  gap::PreparedRecord excerpt = record;
  excerpt.lead_in = {0.01, {0.0, 2e-4, 1e-4}, true};
  const gap::Forces forces = gap::simulate(kDrivenLaws, {record, record, excerpt});
  for (const Eigen::Index most : {1, 7, 256, 1000}) {
    gap::LogDriver driver(kDrivenLaws);
    EXPECT_EQ(driven(driver, record, most, gap::Before::nothing), forces[0]) << most;
    EXPECT_EQ(driven(driver, record, most, gap::Before::another_log), forces[1]) << most;
    EXPECT_EQ(driven(driver, excerpt, most, gap::Before::another_log), forces[2]) << most;
    EXPECT_EQ(driven(driver, record, most, gap::Before::nothing), forces[0]) << "a new component, " << most;
  }
}

// The driver bridges a time gap in the same way as the node and `replay`.
TEST(LogDriver, TakesATimeGapInOneStep) {
  const component::Component component({spring(3e6), maxwell(1.2e6, 2.0)});
  const std::vector<double> z = {0.0, 1e-3, 2e-3, 5e-4};
  std::vector<double> force(z.size());
  gap::LogDriver driver(component.elements());
  driver.begin(gap::Before::nothing);
  driver.drive({0.0, 2, z.data(), nullptr, nullptr, nullptr, nullptr}, 0.002, force.data());
  driver.drive({0.8, 2, z.data() + 2, nullptr, nullptr, nullptr, nullptr}, 0.002, force.data() + 2);
  component::SampleStream stream(component);
  const std::vector<std::int64_t> stamp = {0, 2000000, 802000000, 804000000};
  for (std::size_t i = 0; i < z.size(); ++i) {
    EXPECT_DOUBLE_EQ(force[i], stream.push(stamp[i], z[i]).force.total) << i;
  }
}

}  // namespace
}  // namespace rubber_suspension
