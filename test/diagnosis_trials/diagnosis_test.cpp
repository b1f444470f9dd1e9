// Whole diagnoses of rigs that share no code with the candidates: which effects they name, and how much of the gap they
// close.
#include "diagnosis/shared_runs.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

diagnosis::Diagnosis diagnoseTwo(const RigEffect& effect) {
  return checkedDiagnosis(rigComponent(), runRigs({1, 2}, effect), runRigs({3}, effect));
}

// No effect can be named if only the held-out log shows it, but the model is not confirmed either.
TEST(Diagnosis, DoubtsAModelThatUnseenLogsDoNotConfirm) {
  const diagnosis::Diagnosis result =
      checkedDiagnosis(rigComponent(), runRigs({1, 2}, nothing), {runRig("unseen", 3, stop)});
  EXPECT_GT(result.gaps.unseen.as_configured, 0.05);
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::unknown);
  EXPECT_TRUE(result.answer.effects.empty());
  EXPECT_NE(result.sentence.find("unseen"), std::string::npos) << result.sentence;
}

// Diagnoses four logs and a held-out log.
diagnosis::Diagnosis diagnoseFour(const std::function<RigEffect(unsigned log)>& effect) {
  std::vector<log::Log> logs;
  for (const unsigned log : {1U, 2U, 4U, 5U}) {
    logs.push_back(runRig(std::to_string(log), log, effect(log)));
  }
  return checkedDiagnosis(rigComponent(), logs, {runRig("unseen", 3, effect(3))});
}

// The mean force of an asymmetric law must not be named as an offset, even if all logs have the same mean.
TEST(Diagnosis, LeavesItsMeanToAnAsymmetricLaw) {
  const auto even = [](unsigned) -> RigEffect { return [](double, double z, double) { return 6e7 * z * z; }; };
  const diagnosis::Diagnosis result = diagnoseFour(even);
  EXPECT_EQ(result.answer.effects, std::vector<std::string>{"asymmetric_stiffness"}) << result.sentence;
}

// A drift that differs in each log cannot be predicted on other logs, but each log shows it.
TEST(Diagnosis, NamesADriftThatIsNewInEachLog) {
  const auto drift = [](unsigned log) -> RigEffect {
    std::mt19937 generator(log);
    std::normal_distribution<double> normal(0.0, 1.0);
    std::vector<double> walk(6);
    std::generate(walk.begin(), walk.end(), [&] { return 250.0 * normal(generator); });
    return [walk](double time, double, double) {
      const double place = time / 20.0 * 5.0;
      const auto knot = std::min<std::size_t>(4, static_cast<std::size_t>(place));
      return walk[knot] + (place - static_cast<double>(knot)) * (walk[knot + 1] - walk[knot]);
    };
  };
  const diagnosis::Diagnosis result = diagnoseFour(drift);
  EXPECT_EQ(result.answer.effects, std::vector<std::string>{"force_drift"}) << result.sentence;
}

TEST(Diagnosis, NamesDryFriction) {
  const RigEffect friction =
      ofSteps([force = 0.0](double step) mutable { return force = std::clamp(force + 2e6 * step, -150.0, 150.0); });
  const diagnosis::Diagnosis result = diagnoseTwo(friction);
  ASSERT_FALSE(result.answer.effects.empty()) << result.sentence;
  EXPECT_EQ(result.answer.effects.front(), "friction");
}

// Records a log of the rig on a mount whose `deflection` [m] is a function of the force [N].
log::Log runOnMount(const std::string& name, unsigned seed, const std::function<double(double)>& deflection,
                    const RigEffect& effect = nothing) {
  log::Log log = runRig(name, seed, effect, 0.0);
  for (std::size_t i = 0; i < log.size(); ++i) {
    log.displacement[i] += deflection(log.force[i]);
  }
  addNoise(log.force, 5.0, seed);
  return log;
}

diagnosis::Diagnosis diagnoseOnMount(const std::function<double(double)>& deflection,
                                     const io::ComponentDescription& component = rigComponent()) {
  return checkedDiagnosis(component, {runOnMount("one", 1, deflection), runOnMount("two", 2, deflection)},
                          {runOnMount("unseen", 3, deflection)});
}

// A linear component on a linear mount is linear, so other values of the model fit as well as the mount.
TEST(Diagnosis, TakesAMountForItselfOrForWrongValues) {
  constexpr double kMount = 6e6;  // [N/m]
  const diagnosis::Diagnosis result = diagnoseOnMount([](double force) { return force / kMount; });
  EXPECT_TRUE(mayBe(result, "series_compliance") || result.answer.verdict == diagnosis::Verdict::parameter_error)
      << result.sentence;
}

// If the model stiffens, a mount matters most at large forces. Other values imitate a mount with a fifteenth of the
// compliance, up to 0.5 % of the force.
TEST(Diagnosis, TakesAMountBesideStiffeningForItselfOrForWrongValues) {
  constexpr double kMount = 2e7;   // stiffness [N/m], so a fifteenth of the compliance
  constexpr double kCubic = 2e11;  // stiffness [N/m^3]; it has 1.6 kN of the force of 4 kN
  const auto stiffening = [](double, double z, double) { return kCubic * z * z * z; };
  const auto deflection = [](double force) { return force / kMount; };
  io::ComponentDescription component = rigComponent();
  component.add.push_back({"progressive_stiffness", {{"cubic", {kCubic}}}});
  const diagnosis::Diagnosis result = checkedDiagnosis(
      component, {runOnMount("one", 1, deflection, stiffening), runOnMount("two", 2, deflection, stiffening)},
      {runOnMount("unseen", 3, deflection, stiffening)});
  EXPECT_TRUE(mayBe(result, "series_compliance") || result.answer.verdict == diagnosis::Verdict::parameter_error)
      << result.sentence;
}

// The mount is softer in tension, without the candidate's kink. Asymmetric stiffness with a dynamic stiffness 20 %
// below the data sheet would have a gap of only twice the noise. A tolerance of 5 % rules it out.
TEST(Diagnosis, FindsAnUnevenMountThatReEstimationHides) {
  constexpr double kMount = 5e6;  // [N/m]
  io::ComponentDescription component = rigComponent();
  estimation::Specification sheet = component.written();
  sheet.setTolerance({0.05});
  component.specify(sheet);
  const diagnosis::Diagnosis result =
      diagnoseOnMount([](double force) { return force / kMount * (1.0 + 0.2 * std::tanh(force / 400.0)); }, component);
  ASSERT_FALSE(result.answer.effects.empty()) << result.sentence;
  EXPECT_EQ(result.answer.effects.front(), "series_compliance") << result.sentence;
  EXPECT_EQ(result.answer.effects.size(), 1U) << result.sentence;
  // A linear mount or other values may explain the mean compliance, but not the additional compliance in tension.
  double opening = 0.0;
  for (const element::ElementDescription& entry : result.law.augmented.add) {
    ASSERT_EQ(entry.type, "series_compliance");
    const auto side = entry.values.find("side");
    if (side != entry.values.end()) {
      EXPECT_EQ(side->second.front(), 1.0);
      opening += 1.0 / entry.value("stiffness");
    }
  }
  // At forces of 1 to 2 kN, the mean of the tanh is 0.5 to 0.8.
  EXPECT_NEAR(opening, 0.3 / kMount, 0.15 / kMount);
}

TEST(Diagnosis, FindsAMassThroughTheNoiseOfTheDisplacement) {
  const auto withMass = [](const std::string& name, unsigned seed) {
    constexpr double kMass = 150.0;  // [kg]
    constexpr double kStep = 0.004;  // time step of the rig [s]
    log::Log log = runRig(name, seed, nothing, 0.0);
    const std::vector<double> z = log.displacement;
    for (std::size_t i = 1; i + 1 < z.size(); ++i) {
      log.force[i] += kMass * (z[i - 1] - 2.0 * z[i] + z[i + 1]) / (kStep * kStep);
    }
    addNoise(log.displacement, 3e-6, seed);  // 70 N of inertia force
    addNoise(log.force, 20.0, seed + 10);
    return log;
  };
  const diagnosis::Diagnosis result =
      checkedDiagnosis(rigComponent(), {withMass("one", 1), withMass("two", 2)}, {withMass("unseen", 3)});
  ASSERT_FALSE(result.answer.effects.empty()) << result.sentence;
  EXPECT_EQ(result.answer.effects.front(), "inertia") << result.sentence;
  // The node cannot look ahead. Without the filter in augmented.yaml, noise would cause an inertia force of 190 N, more
  // than the motion causes.
  EXPECT_GT(result.gaps.closed, 0.5) << result.sentence;
}

// The flow is accelerated by stress (Eyring's hyperbolic sine). Friction and relaxation together fit it worse.
TEST(Diagnosis, ClosesMostOfCouplingOfRateAndAmplitudeByCouplingAlone) {
  const RigEffect flow = ofSteps([force = 0.0](double step) mutable {
    constexpr int kSubsteps = 50;
    for (int i = 0; i < kSubsteps; ++i) {
      force += 5e5 * (step / kSubsteps) -
               0.004 / kSubsteps * 15.0 * 200.0 * std::sinh(std::clamp(force / 200.0, -20.0, 20.0));
    }
    return force;
  });
  const diagnosis::Diagnosis result = diagnoseTwo(flow);
  ASSERT_FALSE(result.answer.effects.empty()) << result.sentence;
  if (result.answer.effects == std::vector<std::string>{"rate_amplitude_coupling"}) {
    return;
  }
  // Friction with relaxation comes close, so the coupling may not be named. Gaps of named effects are those of the
  // written file, all others those of the full laws. So only gaps of the same kind are compared.
  const auto least = std::min_element(
      result.candidates.begin(), result.candidates.end(),
      [](const auto& x, const auto& y) { return std::tie(x.written, x.gap) < std::tie(y.written, y.gap); });
  EXPECT_EQ(least->effect, "rate_amplitude_coupling") << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
