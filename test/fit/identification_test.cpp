// Identification from synthetic logs: true values are found, intervals have their stated coverage, and parameters that
// the logs do not show are reported.
#include "rubber_suspension/fit/identification.h"

#include "rubber_suspension/gap/replay.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

const Entries kTruth = {spring(3e6), friction(4900.0, 2.2e-3), maxwell(0.5e6, 1.45)};

// A typical start of the fit, with all values off.
const Entries kGuess = {spring(2e6), friction(9000.0, 1e-3), maxwell(1e6, 4.0)};

// Simulates elements under a sum of sines with several frequencies and amplitudes, sampled at a constant rate [Hz].
log::Log measured(const Entries& elements, double duration, double rate) {
  log::Log log = recorded(rate, duration, [](double t) {
    const double swell = 1.0 + 0.8 * std::sin(2.0 * element::kPi * 0.11 * t);
    return 1.5e-3 * swell * std::sin(2.0 * element::kPi * 0.7 * t) +
           0.6e-3 * std::sin(2.0 * element::kPi * 3.3 * t + 1.0) + 0.1e-3 * std::sin(2.0 * element::kPi * 11.0 * t);
  });
  log.force = gap::simulateLog(component::Component(elements), log);
  return log;
}

fit::IdentificationOptions starts(int number) {
  fit::IdentificationOptions options;
  options.starts = number;
  return options;
}

// Adds noise with a correlation of 0.9 between neighbouring samples.
void addCorrelatedNoise(log::Log& measurement, double deviation, std::mt19937& generator) {
  std::normal_distribution<double> normal;
  const double correlation = 0.9;
  double noise = normal(generator);
  for (double& force : measurement.force) {
    force += deviation * noise;
    noise = correlation * noise + std::sqrt(1.0 - correlation * correlation) * normal(generator);
  }
}

const fit::IdentifiedParameter& find(const fit::Identification& result, const std::string& element,
                                     const std::string& name) {
  for (const fit::IdentifiedParameter& parameter : result.parameters) {
    if (parameter.element == element && parameter.name == name) {
      return parameter;
    }
  }
  throw std::out_of_range(element + "." + name);
}

double truth(const fit::IdentifiedParameter& parameter) {
  for (const element::ElementDescription& element : kTruth) {
    if (element.type == parameter.element) {
      return element.value(parameter.name);
    }
  }
  throw std::out_of_range(parameter.element);
}

// An unconstrained search would lead to gamma > beta, which the Bouc-Wen law refuses.
TEST(Identification, StaysWithinWhatALawAcceptsTogether) {
  const log::Log log = measured({spring(3e6), entry("bouc_wen stiffness=1e6 beta=900 gamma=890")}, 10.0, 200.0);
  const fit::Identification result =
      fit::identify({spring(2e6), entry("bouc_wen stiffness=2e6 beta=500 gamma=450")}, {log}, starts(6));
  EXPECT_NEAR(find(result, "bouc_wen", "beta").value, 900.0, 5.0);
  EXPECT_LE(std::abs(find(result, "bouc_wen", "gamma").value), find(result, "bouc_wen", "beta").value);
  EXPECT_LT(result.relative_residual, 1e-3);
}

TEST(Identification, FindsTheTruthInAnExactLog) {
  log::Log measurement = measured(kTruth, 10.0, 200.0);
  for (double& force : measurement.force) {
    force += 123.0;  // offset of the force sensor
  }
  const fit::Identification result = fit::identify(kGuess, {measurement});
  ASSERT_EQ(result.parameters.size(), 5u);
  for (const fit::IdentifiedParameter& parameter : result.parameters) {
    EXPECT_NEAR(parameter.value / truth(parameter), 1.0, 1e-4) << parameter.element << "." << parameter.name;
    EXPECT_TRUE(parameter.determined);
  }
  EXPECT_NEAR(result.force_offset, 123.0, 1.0);
  EXPECT_LT(result.relative_residual, 1e-8);
  EXPECT_TRUE(result.undetermined.empty());
  EXPECT_GE(result.starts_at_best, 1);
}

class IdentificationOf : public testing::TestWithParam<element::ElementDescription> {};

INSTANTIATE_TEST_SUITE_P(
    FormsOfRubberAndRigs, IdentificationOf,
    testing::Values(entry("first_loading stiffness=1e6 yield_share=0.2"),
                    entry("variable_friction stiffness=1e6 yield_displacement=2e-4 growth_displacement=1e-3"),
                    entry("viscoplastic_friction stiffness=1e6 yield_displacement=2e-4 half_rate=1e-2"),
                    entry("sliding_maxwell stiffness=1e6 break_frequency=2 yield_displacement=4e-4"),
                    entry("payne_maxwell stiffness=1e6 break_frequency=2 recovery_time=0.3 travel=1e-3"),
                    entry("transient_network stiffness=1e6 break_frequency=2 recovery_time=0.3 travel=1e-3"),
                    entry("friction_behind_play stiffness=1e6 yield_displacement=4e-4 gap=2e-4"),
                    entry("maxwell_behind_play stiffness=1e6 break_frequency=5 gap=3e-4"),
                    entry("stress_softening reduction=0.3 width=0.4 path=0.01 reach_exponent=1 full_reach=5e-3")),
    [](const auto& test) { return test.param.type; });

// Fits a law and a spring, starting from values of the law 20 % off. Only forces are compared, because parameters of a
// law may compensate each other, such as the reduction and the reach of softening.
TEST_P(IdentificationOf, FindsTheForceAgain) {
  element::ElementDescription guess = GetParam();
  for (auto& [name, values] : guess.values) {
    values[0] *= 1.2;
  }
  const log::Log log = measured({spring(3e6), GetParam()}, 10.0, 200.0);
  // The force of the law is some per cent of the total force. At a wrong optimum the residual is 1e-3 or more.
  EXPECT_LT(fit::identify({spring(3e6), guess}, {log}, starts(2)).relative_residual, 2e-4);
}

TEST(Identification, IntervalsHoldTheTruth95TimesIn100) {
  // The number of intervals out of 100 that contain the truth is binomial with p = 0.95. For each of the five
  // parameters, the number is outside [88, 99] with a probability below 1 %.
  const int logs = 100;
  std::mt19937 generator(42);
  std::map<std::string, int> held;
  const log::Log clean = measured(kTruth, 8.0, 150.0);
  for (int i = 0; i < logs; ++i) {
    log::Log measurement = clean;
    addCorrelatedNoise(measurement, 100.0, generator);
    for (const fit::IdentifiedParameter& parameter : fit::identify(kTruth, {measurement}, starts(1)).parameters) {
      const double value = truth(parameter);
      held[parameter.element + "." + parameter.name] += parameter.lower <= value && value <= parameter.upper ? 1 : 0;
    }
  }
  ASSERT_EQ(held.size(), 5u);
  for (const auto& [name, count] : held) {
    EXPECT_GE(count, 88) << name;
    EXPECT_LE(count, 99) << name;
    RecordProperty(name, count);
  }
}

TEST(Identification, IgnoringTheCorrelationWouldBeWrong) {
  log::Log measurement = measured(kTruth, 20.0, 200.0);
  std::mt19937 generator(7);
  addCorrelatedNoise(measurement, 100.0, generator);
  const fit::Identification result = fit::identify(kTruth, {measurement});
  // With a correlation of 0.9 between neighbours, (1 + 0.9)/(1 - 0.9) = 19 samples count as one independent sample.
  EXPECT_NEAR(static_cast<double>(measurement.force.size()) / result.independent_samples, 19.0, 8.0);
  EXPECT_NEAR(result.residual, 100.0, 15.0);
}

TEST(Identification, SeveralLogsAreTakenTogether) {
  std::vector<log::Log> measurements = {measured(kTruth, 6.0, 200.0), measured(kTruth, 9.0, 100.0)};
  std::mt19937 generator(3);
  for (log::Log& measurement : measurements) {
    addCorrelatedNoise(measurement, 20.0, generator);
  }
  const fit::Identification one = fit::identify(kTruth, {measurements[0]});
  const fit::Identification both = fit::identify(kTruth, measurements);
  const auto width = [](const fit::Identification& result) {
    const fit::IdentifiedParameter& parameter = find(result, "spring", "stiffness");
    return parameter.upper - parameter.lower;
  };
  EXPECT_LT(width(both), width(one));
}

TEST(Identification, SaysWhatALogDoesNotShow) {
  // A single sine determines two numbers, but there are three parameters: spring, Maxwell stiffness and break
  // frequency. The transient at the start would determine the third, but is lost in the noise.
  const Entries maxwell = {kTruth[0], kTruth[2]};
  log::Log measurement = recorded(200.0, 4.0, [](double t) { return 1e-3 * std::sin(2.0 * element::kPi * 4.0 * t); });
  measurement.force = gap::simulateLog(component::Component(maxwell), measurement);
  std::mt19937 generator(5);
  addCorrelatedNoise(measurement, 400.0, generator);
  const fit::Identification result = fit::identify(maxwell, {measurement});
  EXPECT_FALSE(result.undetermined.empty());
  EXPECT_FALSE(find(result, "maxwell", "break_frequency").determined);
}

TEST(Identification, TwoEqualElementsShareOneStiffness) {
  const Entries two = {kTruth[0], kTruth[0]};
  const fit::Identification result = fit::identify(two, {measured(two, 4.0, 200.0)});
  double sum = 0.0;
  for (const fit::IdentifiedParameter& parameter : result.parameters) {
    sum += parameter.value;
    EXPECT_FALSE(parameter.determined);
  }
  EXPECT_NEAR(sum / 6e6, 1.0, 1e-9);
  ASSERT_EQ(result.undetermined.size(), 1u);
  EXPECT_TRUE(std::isinf(result.undetermined[0].standard_deviation));
  ASSERT_EQ(result.undetermined[0].weights.size(), 2u);
  // A larger value of one stiffness is compensated by a smaller value of the other.
  EXPECT_LT(result.undetermined[0].weights[0].second * result.undetermined[0].weights[1].second, 0.0);
}

TEST(Identification, AnElementThatIsNotThereIsLeftOut) {
  log::Log measurement = measured({kTruth[0]}, 4.0, 200.0);
  for (std::size_t i = 0; i < measurement.force.size(); ++i) {
    measurement.force[i] -=
        100.0 * (i > 0 ? (measurement.displacement[i] - measurement.displacement[i - 1]) * 200.0 : 0.0);
  }
  // The log adds energy, which a dashpot cannot do, so the fitted damping is zero.
  const fit::Identification result = fit::identify({kTruth[0], dashpot(1000.0)}, {measurement});
  ASSERT_EQ(result.elements.size(), 1u);
  EXPECT_EQ(find(result, "dashpot", "damping").value, 0.0);
  EXPECT_FALSE(find(result, "dashpot", "damping").determined);
  EXPECT_EQ(find(result, "dashpot", "damping").index, -1);
  EXPECT_THAT(result.notes, ::testing::Contains(HasSubstr("dashpot")));
}

TEST(Identification, HeldParametersStay) {
  const log::Log measurement = measured(kTruth, 6.0, 200.0);
  fit::IdentificationOptions options;
  options.held = {"maxwell.break_frequency", "friction.displacement", "friction.maximum_force"};
  const fit::Identification result = fit::identify(kTruth, {measurement}, options);
  EXPECT_EQ(result.parameters.size(), 2u);
  EXPECT_EQ(result.elements[1].value("maximum_force"), 4900.0);
  EXPECT_NEAR(find(result, "maxwell", "stiffness").value / 0.5e6, 1.0, 1e-3);
  options.held = {"maxwell.break_freqency"};
  EXPECT_THROW(fit::identify(kTruth, {measurement}, options), std::invalid_argument);
}

TEST(Identification, EffectsInSeriesAreSearchedAsAWhole) {
  const Entries mounted = {kTruth[0], kTruth[2], entry("series_compliance stiffness=9e6")};
  Entries guess = mounted;
  guess[0].values["stiffness"] = {2.5e6};
  guess[1].values["break_frequency"] = {2.0};
  const log::Log measurement = measured(mounted, 6.0, 100.0);
  fit::IdentificationOptions options = starts(2);
  // Spring, Maxwell element and mount have one parameter more than K* determines, so the mount's stiffness is fixed.
  options.held = {"series_compliance.stiffness"};
  const fit::Identification result = fit::identify(guess, {measurement}, options);
  EXPECT_NEAR(find(result, "spring", "stiffness").value / 3e6, 1.0, 1e-4);
  EXPECT_NEAR(find(result, "maxwell", "break_frequency").value / 1.45, 1.0, 1e-3);
}

TEST(Identification, NoiseOfTheDisplacementSetsTheDeadBand) {
  log::Log measurement = measured(kTruth, 8.0, 1000.0);
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  for (double& displacement : measurement.displacement) {
    displacement += 2e-6 * normal(generator);
  }
  EXPECT_NEAR(fit::noiseStandardDeviation(measurement.displacement), 2e-6, 0.2e-6);
  const fit::Identification result = fit::identify(kTruth, {measurement});
  EXPECT_NEAR(result.elements[1].value("dead_band"), 12e-6, 1.2e-6);
  for (const fit::IdentifiedParameter& parameter : result.parameters) {
    // The dead band suppresses reversals smaller than 12 um, which changes the friction by some per cent.
    EXPECT_NEAR(parameter.value / truth(parameter), 1.0, 0.12) << parameter.name;
  }
}

TEST(Identification, RefusesLogsThatSayNothing) {
  EXPECT_THROW(fit::identify(kTruth, {}), std::invalid_argument);
  const std::pair<const char*, void (*)(log::Log&)> changes[] = {
      {"a force that is no number", [](log::Log& log) { log.force[3] = NAN; }},
      {"a force too few", [](log::Log& log) { log.force.pop_back(); }},
      {"a stamp twice", [](log::Log& log) { log.stamp[5] = log.stamp[4]; }},
      {"no motion", [](log::Log& log) { std::fill(log.displacement.begin(), log.displacement.end(), 1e-3); }}};
  for (const auto& [name, change] : changes) {
    log::Log log = measured(kTruth, 2.0, 100.0);
    change(log);
    EXPECT_THROW(fit::identify(kTruth, {log}), std::invalid_argument) << name;
  }
}

}  // namespace
}  // namespace rubber_suspension
