// Whole diagnoses of rigs that share no code with the candidates: the effects they name, and the share of the gap that
// is closed.
#include "diagnosis/shared_runs.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

diagnosis::Diagnosis diagnoseTwo(const RigEffect& effect) {
  return checkedDiagnosis(rigComponent(), runRigs({1, 2}, effect), runRigs({3}, effect));
}

// An effect that only the held-out log shows cannot be named, but the model is not confirmed either.
TEST(Diagnosis, DoubtsAModelThatUnseenLogsDoNotConfirm) {
  const diagnosis::Diagnosis result =
      checkedDiagnosis(rigComponent(), runRigs({1, 2}, nothing), {runRig("unseen", 3, stop)});
  EXPECT_GT(result.gaps.unseen.as_configured, 0.05);
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::unknown);
  EXPECT_TRUE(result.answer.effects.empty());
  EXPECT_NE(result.sentence.find("unseen"), std::string::npos) << result.sentence;
}

// Diagnoses four logs and a held-out one.
diagnosis::Diagnosis diagnoseFour(const std::function<RigEffect(unsigned log)>& effect) {
  std::vector<log::Log> logs;
  for (const unsigned log : {1U, 2U, 4U, 5U}) {
    logs.push_back(runRig(std::to_string(log), log, effect(log)));
  }
  return checkedDiagnosis(rigComponent(), logs, {runRig("unseen", 3, effect(3))});
}

// The mean of an asymmetric law is no separate offset, even if it is equal in all logs.
TEST(Diagnosis, LeavesItsMeanToAnAsymmetricLaw) {
  const auto even = [](unsigned) -> RigEffect { return [](double, double z, double) { return 6e7 * z * z; }; };
  const diagnosis::Diagnosis result = diagnoseFour(even);
  EXPECT_EQ(result.answer.effects, std::vector<std::string>{"asymmetric_stiffness"}) << result.sentence;
}

// A drift that is different in each log cannot be predicted, but each log shows it.
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

// Records a log of the rig behind a mount whose `deflection` [m] depends on the force [N].
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

// A linear component on a mount is linear again, so other values of the model fit as well.
TEST(Diagnosis, TakesAMountForItselfOrForWrongValues) {
  constexpr double kMount = 6e6;  // [N/m]
  const diagnosis::Diagnosis result = diagnoseOnMount([](double force) { return force / kMount; });
  EXPECT_TRUE(mayBe(result, "series_compliance") || result.answer.verdict == diagnosis::Verdict::parameter_error)
      << result.sentence;
}

// Beside stiffening in the model, a mount matters most at large forces: other values imitate a fifteenth of the
// compliance except for 0.5 % of the force.
TEST(Diagnosis, TakesAMountBesideStiffeningForItselfOrForWrongValues) {
  constexpr double kMount = 2e7;   // [N/m], a fifteenth of the compliance
  constexpr double kCubic = 2e11;  // [N/m^3], 1.6 kN of 4 kN
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

// The joint is softer in tension, without the candidate's kink. Asymmetric stiffness would leave a gap of twice the
// noise with a dynamic stiffness 20 % below the data sheet, which only a tolerance of 5 % rules out.
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
  // A linear mount or other values may explain the even part, but not the additional compliance in tension.
  double opening = 0.0;
  for (const element::ElementDescription& entry : result.law.augmented.add) {
    ASSERT_EQ(entry.type, "series_compliance");
    const auto side = entry.values.find("side");
    if (side != entry.values.end()) {
      EXPECT_EQ(side->second.front(), 1.0);
      opening += 1.0 / entry.value("stiffness");
    }
  }
  // tanh averages 0.5 to 0.8 at forces of 1 to 2 kN.
  EXPECT_NEAR(opening, 0.3 / kMount, 0.15 / kMount);
}

TEST(Diagnosis, FindsAMassThroughTheNoiseOfTheDisplacement) {
  const auto withMass = [](const std::string& name, unsigned seed) {
    constexpr double kMass = 150.0;  // [kg]
    constexpr double kStep = 0.004;  // [s], of the rig
    log::Log log = runRig(name, seed, nothing, 0.0);
    const std::vector<double> z = log.displacement;
    for (std::size_t i = 1; i + 1 < z.size(); ++i) {
      log.force[i] += kMass * (z[i - 1] - 2.0 * z[i] + z[i + 1]) / (kStep * kStep);
    }
    addNoise(log.displacement, 3e-6, seed);  // 70 N after second differences
    addNoise(log.force, 20.0, seed + 10);
    return log;
  };
  const diagnosis::Diagnosis result =
      checkedDiagnosis(rigComponent(), {withMass("one", 1), withMass("two", 2)}, {withMass("unseen", 3)});
  ASSERT_FALSE(result.answer.effects.empty()) << result.sentence;
  EXPECT_EQ(result.answer.effects.front(), "inertia") << result.sentence;
  // The node cannot look ahead: without the filter of augmented.yaml, noise would cause 190 N of inertia force, more
  // than the motion does.
  EXPECT_GT(result.gaps.closed, 0.5) << result.sentence;
}

// Flow accelerated by stress (Eyring's hyperbolic sine); friction and relaxation, even together, fit it worse.
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
  // The coupling is named only if no other set explains the gap, and friction with relaxation comes close here. Gaps of
  // named effects are of the written file, others are of full laws, and only these are compared.
  const auto least = std::min_element(
      result.candidates.begin(), result.candidates.end(),
      [](const auto& x, const auto& y) { return std::tie(x.written, x.gap) < std::tie(y.written, y.gap); });
  EXPECT_EQ(least->effect, "rate_amplitude_coupling") << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
