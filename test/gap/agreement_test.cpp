// Measures of agreement between a measured and a simulated force, with limits, table and JSON.
#include "gap/agreement.h"

#include <nlohmann/json.hpp>

#include "rubber_suspension/element/constants.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

constexpr double kAmplitude = 1e-3;  // [m]
constexpr double kForce = 2000.0;    // [N]

// Records ten cycles of 10 Hz, sampled at 1 kHz. The force leads the displacement by an angle [rad].
log::Log sine(double angle) {
  constexpr double kOmega = 2.0 * element::kPi * 10.0;
  log::Log log = recorded(
      1e3, 1.001, [](double t) { return kAmplitude * std::sin(kOmega * t); },
      [&](double t, double /*z*/) { return kForce * std::sin(kOmega * t + angle); });
  log.name = "sine";
  return log;
}

// The energy per cycle is pi times both amplitudes times the sine of the angle. Straight lines of a hundredth of a
// cycle reduce the energy by sin(x)/x of a step, 0.07 %.
TEST(Agreement, OfASineWithTooSmallAnAngle) {
  const log::Log log = sine(0.2);
  const gap::Agreement a = gap::agreementOf(log, sine(0.1).force);
  EXPECT_NEAR(a.peak, kForce * 2.0 * std::sin(0.05), 0.002 * a.peak);
  EXPECT_NEAR(a.rms, kForce * 2.0 * std::sin(0.05) / std::sqrt(2.0), 1e-3 * a.rms);
  EXPECT_NEAR(a.gap, 2.0 * std::sin(0.05), 1e-3);
  ASSERT_TRUE(a.measured_energy && a.energyError());
  EXPECT_NEAR(*a.measured_energy, element::kPi * kAmplitude * kForce * std::sin(0.2), 1e-3 * *a.measured_energy);
  EXPECT_NEAR(*a.energyError(), std::sin(0.1) / std::sin(0.2) - 1.0, 1e-6);
  EXPECT_TRUE(a.iso18571.repeats);
  EXPECT_LT(a.iso18571.phase, 1.0);
}

TEST(Agreement, LeavesOutTheStart) {
  const log::Log log = sine(0.2);
  std::vector<double> force = log.force;
  force[99] += 1e6;
  EXPECT_EQ(gap::agreementOf(log, force).peak_time, 0.099);
  EXPECT_EQ(gap::agreementOf(log, force, 100).peak, 0.0);
  EXPECT_THROW(gap::agreementOf(log, force, 1000), std::invalid_argument);
  EXPECT_THROW(gap::agreementOf(log, {1.0, 2.0}), std::invalid_argument);
}

// The rating resamples at even steps: missing samples are interpolated linearly.
TEST(Agreement, RatesAtEvenSteps) {
  const auto pulse = [](int i, double middle) { return std::exp(-std::pow((i - middle) / 60.0, 2)); };
  const log::Log log = logOf(
      "pulse", 600, 1000000, [](int i) { return 1e-3 * i; }, [&](int i, double /*z*/) { return pulse(i, 300.0); });
  log::Log thinned;
  std::vector<double> simulated;
  std::vector<double> simulated_thinned;
  for (int i = 0; i < 600; ++i) {
    const auto sample = static_cast<std::size_t>(i);
    simulated.push_back(0.9 * pulse(i, 312.0));
    if (i < 300 || i % 2 == 0) {
      thinned.stamp.push_back(log.stamp[sample]);
      thinned.displacement.push_back(log.displacement[sample]);
      thinned.force.push_back(log.force[sample]);
      simulated_thinned.push_back(simulated.back());
    }
  }
  const gap::Agreement whole = gap::agreementOf(log, simulated);
  EXPECT_NEAR(gap::agreementOf(thinned, simulated_thinned).iso18571.total, whole.iso18571.total, 2e-3);
  EXPECT_FALSE(whole.measured_energy) << "a ramp has no cycle";
}

TEST(Agreement, IsHeldAgainstLimits) {
  gap::ComparedForce compared{"", gap::agreementOf(sine(0.2), sine(0.1).force), {}};
  EXPECT_EQ(gap::beyondLimits(compared), "");
  compared.limits.rms = 150.0;
  compared.limits.iso18571 = 0.5;
  EXPECT_EQ(gap::beyondLimits(compared), "");
  EXPECT_THAT(gap::agreementTable(compared), HasSubstr("at most 150 N: kept"));
  compared.limits.energy = 0.05;
  compared.limits.iso18571 = 0.999;
  EXPECT_THAT(gap::beyondLimits(compared), HasSubstr("energy per cycle"));
  EXPECT_THAT(gap::beyondLimits(compared), HasSubstr("accepted: at most 5 %"));
  EXPECT_THAT(gap::agreementTable(compared), HasSubstr("at least 0.999: BEYOND"));
  EXPECT_THAT(gap::agreementTable(compared), HasSubstr("is periodic"));
}

TEST(Agreement, AsJson) {
  gap::ComparedForce compared{"", gap::agreementOf(sine(0.2), sine(0.1).force), {}};
  compared.limits.peak = 1.0;
  const auto json = nlohmann::json::parse(gap::agreementJson("bush", "sine", {compared}));
  EXPECT_EQ(json.at("iso18571").at("total").get<double>(), compared.agreement.iso18571.total);
  EXPECT_EQ(json.at("rms_N").get<double>(), compared.agreement.rms);
  EXPECT_EQ(json.at("beyond_limits"), nlohmann::json({"peak error"}));
  compared.direction = "rz";
  const auto six = nlohmann::json::parse(gap::agreementJson("bush", "sine", {compared}));
  EXPECT_EQ(six.at("directions").at("rz").at("peak_error_Nm").get<double>(), compared.agreement.peak);
}

}  // namespace
}  // namespace rubber_suspension
