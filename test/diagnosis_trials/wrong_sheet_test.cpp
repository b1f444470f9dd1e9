// Benches whose model has the right form, but values from a wrong data sheet.
#include "diagnosis/checked_diagnosis.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

constexpr int kSamples = 10000;
constexpr double kStep = 0.002;  // [s]

// Returns the model with static and dynamic stiffness given as factors of the true ones.
io::ComponentDescription sheet(double k_st, double k_n, const std::string& tolerance = "10 %") {
  const std::string text = fmt::format(
      "components:\n  bush:\n    model: multi_maxwell\n    specification:\n      tolerance: {}\n"
      "      static_stiffness: {:.4f} kN/mm\n      dynamic_stiffness: {:.4f} kN/mm\n      nominal_frequency: 5\n"
      "      maximum_stiffness: 1.4028 kN/mm\n      high_frequency: 24\n",
      tolerance, 0.9633 * k_st, 1.2859 * k_n);
  return componentOf(text);
}

double sines(double t) {
  const double w = 2.0 * element::kPi * t;
  return 1.2 * std::sin(0.5 * w) + 0.8 * std::sin(2.1 * w + 1.0) + 0.5 * std::sin(5.3 * w + 2.0) +
         0.3 * std::sin(11.0 * w + 3.0);
}

double sweep(double t) { return 0.9 * std::sin(2.0 * element::kPi * 0.2 * (std::pow(90.0, t / 20.0) - 1.0) * 4.4446); }

double hold(double t) { return t < 1.0 ? 2.0 * t : t < 8.0 ? 2.0 : t < 8.5 ? 2.0 - 7.0 * (t - 8.0) : -1.5; }

// Records the true component under a motion [mm], with noise of 0.5 % of the force.
log::Log record(const std::string& name, double (*motion)(double), unsigned seed) {
  log::Log log = logOf(name, kSamples, std::llround(kStep * 1e9), [&](int i) {
    const double t = kStep * i;
    return 1e-3 * std::min({1.0, t / 0.5, (kStep * kSamples - t) / 0.5}) * motion(t);
  });
  log.force = gap::simulateLog(sheet(1.0, 1.0).makeComponent(), log);
  const double deviation = gap::standardDeviation(Eigen::Map<const Eigen::VectorXd>(log.force.data(), kSamples));
  addNoise(log.force, 0.005 * deviation, seed);
  return log;
}

diagnosis::Diagnosis diagnoseSheet(const io::ComponentDescription& component) {
  return checkedDiagnosis(component, {record("sines", sines, 1), record("sweep", sweep, 2)}, {record("hold", hold, 3)});
}

// If the fit were bound to this data sheet, relaxation would seem to be missing.
TEST(WrongSheet, IsNoMissingEffect) {
  const double true_sheet = diagnoseSheet(sheet(1.0, 1.0)).gaps.unseen.as_configured;
  for (const auto& [k_st, k_n] : {std::pair(1.12, 0.90), std::pair(0.93, 1.06)}) {
    const diagnosis::Diagnosis result = diagnoseSheet(sheet(k_st, k_n));
    EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::parameter_error) << result.sentence;
    EXPECT_LT(result.gaps.unseen.re_estimated, 1.2 * true_sheet);
    EXPECT_THAT(result.sentence, testing::HasSubstr("Deviations in tolerances of the data sheet: K_st"))
        << result.sentence;
    ASSERT_FALSE(result.parameters.sheet_deviations.empty());
    for (const diagnosis::SheetDeviation& number : result.parameters.sheet_deviations) {
      const double off = number.name == "static_stiffness"    ? -std::log(k_st)
                         : number.name == "dynamic_stiffness" ? -std::log(k_n)
                                                              : 0.0;
      EXPECT_NEAR(number.tolerances, off / 0.1, 0.3) << number.name;
    }
  }
}

// Near the resonance of a mass on a spring, a spring fitted alone has a small part of the true stiffness.
TEST(WrongSheet, OfAGuessIsFollowedAsFarAsAGuessMayBeOff) {
  constexpr double kStiffness = 1e6;  // [N/m]; the guess has a thirtieth of it
  constexpr double kMass = 5.3;       // [kg]; the resonance is at 69 Hz
  constexpr double kDamping = 200.0;  // [N s/m]
  constexpr double kRate = 8000.0;    // [Hz], high enough to compute the acceleration by second differences
  const auto guess = componentOf(
      "components:\n  b:\n    model: kelvin_voigt\n    specification: {tolerance: guess, dynamic_stiffness: 33000, "
      "nominal_frequency: 0.05, relative_damping: 0.001}\n");
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, 0.3);
  log::Log log;
  log.name = "about the resonance";
  for (int i = 0; i < 24000; ++i) {
    double z = 0.0;
    double velocity = 0.0;
    double acceleration = 0.0;
    for (const double frequency : {7.0, 31.0, 53.0, 64.0, 69.0, 75.0, 88.0}) {
      const double omega = 2.0 * element::kPi * frequency;
      const double part = 3e-5 * std::sin(omega * i / kRate + frequency);
      z += part;
      velocity += 3e-5 * omega * std::cos(omega * i / kRate + frequency);
      acceleration -= omega * omega * part;
    }
    log.stamp.push_back(std::llround(i * 1e9 / kRate));
    log.displacement.push_back(z);
    log.force.push_back(kStiffness * z + kDamping * velocity + kMass * acceleration + noise(generator));
  }
  const diagnosis::Diagnosis result = checkedDiagnosis(guess, {log}, {});
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::named) << result.sentence;
  EXPECT_THAT(result.answer.effects, testing::ElementsAre("inertia")) << result.sentence;
  ASSERT_FALSE(result.law.effect_sizes.empty());
  EXPECT_NEAR(result.law.effect_sizes.front().value, kMass, 0.02 * kMass);
}

// The same data sheet as a guess: its values are identified, right or wrong.
TEST(WrongSheet, OfAGuessIsIdentified) {
  for (const auto& [k_st, k_n] : {std::pair(1.0, 1.0), std::pair(1.12, 0.90)}) {
    const diagnosis::Diagnosis result = diagnoseSheet(sheet(k_st, k_n, "guess"));
    EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::parameter_error) << result.sentence;
    EXPECT_THAT(result.sentence, testing::HasSubstr("Identified values: K_n 1.2")) << result.sentence;
  }
}

}  // namespace
}  // namespace rubber_suspension
