// The proposed experiment has motions within limits that distinguish explanations even after the wrong one is refitted.
#include "diagnosis/effect.h"
#include "diagnosis/experiment/discrimination.h"
#include "diagnosis/experiment/menu.h"
#include "diagnosis/experiment/next_experiment.h"
#include "diagnosis/hypotheses/search.h"
#include "diagnosis/words/sentence.h"
#include "rig.h"
#include "rubber_suspension/diagnosis/experiment_limits.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

using diagnosis::experiment::Bounds;
using diagnosis::experiment::Experiment;
using diagnosis::experiment::experimentMenu;

Bounds someBounds(double low, double high) {
  Bounds bounds;
  bounds.stroke = diagnosis::experiment::strokeOf(low, high);
  bounds.speed = 0.05;
  bounds.frequency = 10.0;
  bounds.force = 1e9;
  bounds.duration = 30.0;
  bounds.dt = 0.002;
  return bounds;
}

// The rig that recorded the logs can play every proposal, even if its displacements lie on one side of zero.
TEST(Experiments, StayWithinTheBounds) {
  for (const auto& [low, high] : {std::pair(-0.002, 0.0021), {0.004, 0.007}, {-0.003, 0.001}}) {
    const Bounds bounds = someBounds(low, high);
    const auto menu = experimentMenu(bounds);
    ASSERT_GT(menu.size(), 20U);
    for (const Experiment& experiment : menu) {
      const Eigen::VectorXd& z = experiment.displacement;
      // Each motion starts and ends at rest at zero displacement.
      EXPECT_GE(z.minCoeff(), std::min(0.0, low) - 1e-12) << experiment.description;
      EXPECT_LE(z.maxCoeff(), std::max(0.0, high) + 1e-12) << experiment.description;
      EXPECT_EQ(z[0], 0.0) << experiment.description;
      EXPECT_NEAR(z[z.size() - 1], 0.0, 1e-9) << experiment.description;
      const double fastest = (z.tail(z.size() - 1) - z.head(z.size() - 1)).cwiseAbs().maxCoeff() / experiment.dt;
      EXPECT_LE(fastest, bounds.speed * (1.0 + 1e-9)) << experiment.description;
      EXPECT_LE(experiment.duration(), bounds.duration) << experiment.description;
    }
  }
}

TEST(Experiments, HaveMotionsOfEveryKind) {
  std::set<std::string> kinds;
  for (const Experiment& experiment : experimentMenu(someBounds(-0.002, 0.002))) {
    kinds.insert(experiment.kind);
  }
  EXPECT_THAT(kinds,
              testing::IsSupersetOf({"sine", "sweep", "multisine", "steps", "hold", "triangle", "preload",
                                     "small amplitude after a large one", "amplitudes", "repeat", "standstill"}));
}

TEST(Experiments, AreNoneWhereTheBoundsLeaveNoRoom) {
  Bounds bounds = someBounds(-0.002, 0.002);
  bounds.duration = 0.01;
  EXPECT_TRUE(experimentMenu(bounds).empty());
  bounds = someBounds(-0.002, 0.002);
  bounds.stroke.half = 0.0;
  EXPECT_TRUE(experimentMenu(bounds).empty());
}

TEST(Experiments, MultisinesAreOddOrEven) {
  int odd = 0;
  int even = 0;
  for (const Experiment& experiment : experimentMenu(someBounds(-0.002, 0.002))) {
    odd += experiment.kind == "multisine" && experiment.description.find("odd") != std::string::npos ? 1 : 0;
    even += experiment.kind == "multisine" && experiment.description.find("even") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(odd, 2);
  EXPECT_EQ(even, 2);
}

std::string refusal(const std::string& assignment) {
  diagnosis::ExperimentLimits limits;
  return messageOf<std::invalid_argument>([&] { diagnosis::setExperimentLimit(limits, assignment); });
}

TEST(ExperimentLimits, AreReadWithTheirUnits) {
  diagnosis::ExperimentLimits limits;
  for (const char* assignment :
       {"stroke=20 mm", "speed = 0.3 m/s", "frequency=15 Hz", "force=30 kN", "duration=2 min"}) {
    diagnosis::setExperimentLimit(limits, assignment);
  }
  EXPECT_EQ(limits.stroke, 0.02);
  EXPECT_EQ(limits.speed, 0.3);
  EXPECT_EQ(limits.frequency, 15.0);
  EXPECT_EQ(limits.force, 30e3);
  EXPECT_EQ(limits.duration, 120.0);
}

TEST(ExperimentLimits, AreRefusedWithKeyValueAndWhatIsAccepted) {
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(refusal("strok=20 mm"),
              AllOf(HasSubstr("strok"), HasSubstr("did you mean 'stroke'"), HasSubstr("speed")));
  EXPECT_THAT(refusal("stroke"), AllOf(HasSubstr("'=' is missing"), HasSubstr("accepted")));
  EXPECT_THAT(refusal("stroke=20 kN"), AllOf(HasSubstr("stroke"), HasSubstr("20 kN"), HasSubstr("accepted")));
  EXPECT_THAT(refusal("force=-3 kN"), AllOf(HasSubstr("force"), HasSubstr("-3 kN"), HasSubstr("above 0")));
  EXPECT_THAT(refusal("speed=0"), AllOf(HasSubstr("speed"), HasSubstr("above 0")));
  EXPECT_THAT(refusal("duration=inf"), HasSubstr("out of range"));
  EXPECT_THAT(refusal("force=much"), HasSubstr("much"));
}

// Logs of slow triangles show no dependence on the rate, so a dashpot and relaxation are rival explanations of them.
class Rivals : public testing::Test {
 protected:
  Rivals()
      : model_(rigComponent(), fit::Level::specification),
        fitter_({log::makeRecord(slowLog())}, model_, kOneDeviation),
        excitation_(fit::summarise(fitter_.records())) {
    search_.excitation = excitation_;
    search_.candidates = diagnosis::candidates(excitation_);
    search_.noise.floor = 0.005;
    search_.re_estimated.fit.parameters = fitter_.configured({});
    search_.re_estimated.fit.held_out = 0.05;
    search_.as_configured = search_.re_estimated;
    for (int c = 0; c < static_cast<int>(search_.candidates.size()); ++c) {
      diagnosis::hypotheses::FittedHypothesis single{fit::makeHypothesis(search_.candidates, {c}), {}};
      single.fit.parameters = fitter_.configured(single.hypothesis);
      single.fit.held_out = 0.04;
      search_.singles.push_back(single);
    }
    fit::findUnitEffects(search_.candidates, fitter_.records(), 1);
  }

  static log::Log slowLog() {
    log::Log log = runRig("slow", 1, nothing);
    for (std::size_t i = 0; i < log.size(); ++i) {
      const double t = log.time(i);
      log.displacement[i] = 0.002 / 1.5707963 * std::asin(std::sin(0.5 * t));
      log.force[i] = 1e6 * log.displacement[i];
    }
    return log;
  }

  diagnosis::hypotheses::FittedHypothesis& single(const std::string& effect) {
    for (std::size_t c = 0; c < search_.candidates.size(); ++c) {
      if (search_.candidates[c].effect == effect) {
        return search_.singles[c];
      }
    }
    throw std::logic_error(effect);
  }

  // Judges all hypotheses as if `effect` were the answer. All effects have the same size and small form errors, so the
  // judgement expects about the same residual for each hypothesis.
  void judgeAs(int effect) {
    constexpr double kUsualSize = 0.002;  // square of the size relative to the force
    diagnosis::judge::Evidence& evidence = workings_.evidence;
    evidence = diagnosis::hypotheses::evidenceOf(search_);
    evidence.logs = {{search_.noise.floor, 0.0, 1.0, false, 50}};
    for (std::size_t h = 0; h < evidence.hypotheses.size(); ++h) {
      diagnosis::judge::HypothesisEvidence& hypothesis = evidence.hypotheses[h];
      hypothesis.log_errors = {std::pow(search_.at(static_cast<int>(h)).fit.held_out, 2)};
      hypothesis.sizes.assign(hypothesis.members.size(), {kUsualSize});
    }
    workings_.table = diagnosis::judge::scoreTable(evidence);
    workings_.answer = diagnosis::judge::answer(workings_.table);
    workings_.answer.effects = {effect};
    workings_.answer.model = diagnosis::judge::Evidence::kFirstSingle + effect;
    workings_.answer.verdict = diagnosis::Verdict::named;
    workings_.answer.probability = 0.5;
  }

  int placeOf(const std::string& effect) const {
    const auto found = std::find_if(search_.candidates.begin(), search_.candidates.end(),
                                    [&](const fit::Candidate& candidate) { return candidate.effect == effect; });
    return static_cast<int>(found - search_.candidates.begin());
  }

  // Returns the RMS difference that remains after a refit [N].
  double afterRefit(const Experiment& experiment) {
    const std::vector<diagnosis::experiment::Explanation> explanations = {{&single("viscous_damping"), 1.0},
                                                                          {&search_.re_estimated, 0.0}};
    diagnosis::experiment::Discriminator discriminator(fitter_, search_, explanations, 1e9, 1);
    const auto found = discriminator.best({experiment});
    EXPECT_NE(found.experiment, nullptr);
    return found.difference;
  }

  fit::ModelParameters model_;
  fit::Fitter fitter_;
  fit::Excitation excitation_;
  diagnosis::Workings workings_;
  diagnosis::hypotheses::Search& search_ = workings_.search;
};

Experiment motion(const std::function<double(double)>& law) {
  constexpr double kStep = 0.002;
  Experiment experiment{"motion", "motion", kStep, Eigen::VectorXd(10000), 1};
  for (Eigen::Index i = 0; i < experiment.displacement.size(); ++i) {
    experiment.displacement[i] = law(kStep * static_cast<double>(i));
  }
  return experiment;
}

// One Maxwell element can imitate a dashpot exactly at one frequency, but not at two.
TEST_F(Rivals, OneSineCannotTellADashpotFromRelaxationTwoCan) {
  single("viscous_damping").fit.parameters.scales[0] = 2e3;
  const auto sine = [](double f) { return [f](double t) { return 1e-4 * std::sin(2.0 * element::kPi * f * t); }; };
  const double one = afterRefit(motion(sine(4.0)));
  const double two = afterRefit(motion([&](double t) { return sine(1.0)(t) + sine(15.0)(t); }));
  EXPECT_GT(two, 5.0 * one);
}

TEST_F(Rivals, TheBestMotionLeavesLeastOpen) {
  single("viscous_damping").fit.parameters.scales[0] = 2e3;
  std::vector<Experiment> menu;
  for (const double frequency : {0.5, 2.0, 8.0, 15.0}) {
    const auto law = [&](double t) { return 1e-4 * std::sin(2.0 * element::kPi * frequency * t); };
    menu.push_back(motion([&](double t) { return law(t) + 0.3 * law(3.0 * t); }));
  }
  const std::vector<diagnosis::experiment::Explanation> explanations = {{&single("viscous_damping"), 0.6},
                                                                        {&search_.re_estimated, 0.4}};
  diagnosis::experiment::Discriminator discriminator(fitter_, search_, explanations, 1e9, 1);
  const auto best = discriminator.best(menu);
  ASSERT_NE(best.experiment, nullptr);
  EXPECT_LT(best.open, diagnosis::experiment::openNames(explanations, {0.6, 0.4}));
  constexpr double kRounding = 1e-6;  // columns have single precision, and are scaled with those of other motions
  for (const Experiment& experiment : menu) {
    EXPECT_GE(discriminator.best({experiment}).open, best.open - kRounding);
  }
}

// The larger set of effects can imitate the smaller one in any motion, but needs a stop of negligible size to do so.
TEST_F(Rivals, OfSetsThatHoldOneAnotherOneIsDecided) {
  const int damping = placeOf("viscous_damping");
  const int stop = placeOf("bump_stop");
  single("viscous_damping").fit.parameters.scales[0] = 2e3;
  diagnosis::hypotheses::FittedHypothesis both{
      fit::makeHypothesis(search_.candidates, {std::min(damping, stop), std::max(damping, stop)}), {}};
  both.fit.parameters = fitter_.configured(both.hypothesis);
  for (std::size_t t = 0; t < both.hypothesis.places.size(); ++t) {
    const fit::TermPlace place = both.hypothesis.places[t];
    both.fit.parameters.scales[static_cast<Eigen::Index>(t)] = place.term > 0               ? 0.0
                                                               : place.candidate == damping ? 2e3
                                                                                            : 1e5;
  }
  constexpr double usual = 0.05;  // usual size of an effect relative to the force
  const std::vector<diagnosis::experiment::Explanation> explanations = {
      {&single("viscous_damping"), 0.5, 1e-4, 0.0, usual}, {&both, 0.5, 1e-4, 0.0, usual}};
  diagnosis::experiment::Discriminator discriminator(fitter_, search_, explanations, 1e9, 1);
  const auto full = [](double t) { return 0.002 * std::sin(2.0 * element::kPi * 4.0 * t); };
  const auto found = discriminator.best({motion(full)});
  EXPECT_DOUBLE_EQ(diagnosis::experiment::openNames(explanations, {0.5, 0.5}), 1.0) << "of the stop alone";
  EXPECT_LT(found.open, 0.5);
}

// A dashpot of zero damping equals the model in every motion. Fast motions show a dashpot with damping.
TEST_F(Rivals, ProposeNothingThatSettlesNextToNothing) {
  for (diagnosis::hypotheses::FittedHypothesis& other : search_.singles) {
    other.fit.held_out = std::numeric_limits<double>::infinity();  // so that only the model competes with the dashpot
  }
  for (auto* hypothesis : {&single("viscous_damping"), &search_.re_estimated, &search_.as_configured}) {
    hypothesis->fit.held_out = 0.01;  // the slow logs have little residual beyond the noise
  }
  judgeAs(placeOf("viscous_damping"));
  diagnosis::ExperimentLimits limits;
  limits.speed = 0.1;
  limits.frequency = 15.0;
  const auto none = diagnosis::experiment::nextExperiment(fitter_, workings_, limits, 1);
  EXPECT_TRUE(none.proposed.displacement.empty());
  const std::string text = diagnosis::words::experimentText({}, none);
  EXPECT_THAT(text, testing::StartsWith("No motion within the limits decides"));
  EXPECT_THAT(text, testing::HasSubstr("would not be enough"));

  single("viscous_damping").fit.parameters.scales[0] = 2e3;
  const auto proposed = diagnosis::experiment::nextExperiment(fitter_, workings_, limits, 1);
  ASSERT_FALSE(proposed.proposed.displacement.empty());
  EXPECT_LE(proposed.proposed.open_after, 0.75 * proposed.proposed.open_before);
  EXPECT_EQ(proposed.proposed.decides, "viscous_damping");
  EXPECT_GT(proposed.proposed.probability, 0.5);
  EXPECT_THAT(diagnosis::words::experimentText({}, proposed), testing::HasSubstr("between viscous_damping"));
}

TEST_F(Rivals, ProposalsKeepToTheLimitsGiven) {
  single("viscous_damping").fit.parameters.scales[0] = 2e3;
  single("viscous_damping").fit.held_out = 0.01;
  diagnosis::ExperimentLimits limits;
  limits.stroke = 0.004;
  limits.speed = 0.1;
  limits.frequency = 15.0;
  limits.force = 2500.0;
  limits.duration = 12.0;
  for (int c = 0; c < static_cast<int>(search_.candidates.size()); ++c) {
    judgeAs(c);
    const auto proposed = diagnosis::experiment::nextExperiment(fitter_, workings_, limits, 1).proposed;
    for (std::size_t i = 1; i < proposed.displacement.size(); ++i) {
      ASSERT_LE(std::abs(proposed.displacement[i]), 0.004);
      ASSERT_LE(std::abs(proposed.displacement[i] - proposed.displacement[i - 1]), 0.1 * proposed.dt * (1.0 + 1e-9));
      ASSERT_LE(std::abs(1e6 * proposed.displacement[i]), 2500.0);  // the static stiffness is 1e6 N/m
    }
    ASSERT_LE(static_cast<double>(proposed.displacement.size()) * proposed.dt, 12.0);
  }
}

}  // namespace
}  // namespace rubber_suspension
