// Logs that begin under load: the initial state of Berg's friction is attributed to the rig.
#include "diagnosis/checked_diagnosis.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/constants.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

constexpr double kSampleStep = 0.004;  // [s]
constexpr double kBushNoise = 3.0;     // [N]

io::ComponentDescription bush() { return {"bush", {spring(4e5), friction(60.0, 1e-4)}}; }

// Returns a rise to the load in 1 s, a hold, and growing motion about the load until friction has forgotten the rise.
std::vector<double> loadedMotion(double load, double frequency) {
  constexpr int kRise = 250;
  constexpr int kSamples = 5000;
  std::vector<double> displacement;
  for (int i = 0; i < kRise; ++i) {
    displacement.push_back(load * i / kRise);
  }
  for (int i = 0; i < kSamples; ++i) {
    const double time = kSampleStep * i;
    const double amplitude = time < 8.0 ? 0.0 : 1e-3 * (1.0 - std::exp(-0.4 * (time - 8.0)));
    displacement.push_back(load + amplitude * std::sin(2.0 * element::kPi * frequency * time));
  }
  return displacement;
}

// Records a log that begins under load, `before` samples after the motion began.
log::Log recorded(const std::string& name, unsigned seed, const std::vector<double>& displacement, std::size_t before) {
  const component::Component component = bush().makeComponent();
  component::ComponentState state = component.makeState();
  std::vector<double> force(displacement.size());
  component.simulate(state, kSampleStep, displacement.data(), displacement.size(), force.data());
  log::Log log = logOf(
      name, static_cast<int>(displacement.size() - before), 4000000,
      [&](int i) { return displacement[before + static_cast<std::size_t>(i)]; },
      [&](int i, double) { return force[before + static_cast<std::size_t>(i)]; });
  addNoise(log.force, kBushNoise, seed);
  return log;
}

TEST(HeldUnderLoad, LacksNothing) {
  constexpr std::size_t kRise = 250;
  const auto result = checkedDiagnosis(
      bush(), {recorded("up", 1, loadedMotion(1e-3, 1.0), kRise), recorded("down", 2, loadedMotion(-8e-4, 2.0), kRise)},
      {recorded("unseen", 3, loadedMotion(6e-4, 1.5), kRise)});
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::none) << result.sentence;
  // A model that starts from rest at the beginning of the log is off by 60 N for 8 s, and by less afterwards.
  EXPECT_GT(result.gap_as_recorded.as_configured, 0.1);
  EXPECT_LT(result.gaps.unseen.as_configured, 1.5 * result.gaps.unseen.noise_floor);
}

// Adds an offset of the force [N] that wanders over the log, differently in each log.
log::Log drifting(log::Log log, unsigned seed) {
  constexpr std::size_t kLegs = 5;
  std::mt19937 generator(100 + seed);
  std::normal_distribution<double> normal(0.0, 40.0);
  std::vector<double> walk(kLegs + 1);
  std::generate(walk.begin(), walk.end(), [&] { return normal(generator); });
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double place = static_cast<double>(kLegs * i) / static_cast<double>(log.size());
    const auto leg = static_cast<std::size_t>(place);
    log.force[i] += walk[leg] + (place - static_cast<double>(leg)) * (walk[leg + 1] - walk[leg]);
  }
  return log;
}

// Friction of 60 N would be 20 % of the force, but forgets its initial state after a few cycles. On held-out blocks the
// drift is interpolated from both sides, so half of it may remain there as a residual force.
TEST(BergsFriction, HidesNoDrift) {
  const auto run = [](const std::string& name, unsigned seed, double frequency) {
    return drifting(recorded(name, seed, loadedMotion(1e-4, frequency), 0), seed);
  };
  const auto result =
      checkedDiagnosis(bush(), {run("one", 1, 1.0), run("two", 2, 2.0), run("three", 3, 1.3)}, {run("unseen", 4, 1.5)});
  EXPECT_TRUE(mayBe(result, "force_drift")) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
