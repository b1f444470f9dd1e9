// Whole diagnoses of measured tables: named effects alone, with wrong values, and compared with diagnoses of logs.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/laboratory.h"
#include "diagnosis/rig.h"
#include "rubber_suspension/gap/replay.h"
#include "support/test.h"

namespace rubber_suspension::diagnosis {
namespace {

// Simulates logs of all amplitudes and frequencies of the table, with noise of about 1 %.
std::vector<log::Log> logsOf(const io::ComponentDescription& truth) {
  const component::Component component = truth.makeComponent();
  std::vector<log::Log> logs = runRigs({1, 2, 3}, nothing);
  for (unsigned i = 0; i < logs.size(); ++i) {
    logs[i].force = gap::simulateLog(component, logs[i]);
    addNoise(logs[i].force, 15.0, i + 1);
  }
  return logs;
}

// Returns the effects of all sets of effects that the logs cannot distinguish.
std::vector<std::string> listed(const Diagnosis& diagnosis) {
  std::vector<std::string> effects;
  for (const std::vector<std::string>& set : diagnosis.answer.confounded) {
    effects.insert(effects.end(), set.begin(), set.end());
  }
  return effects;
}

// Returns true if wrong values are the verdict or an alternative.
bool mayBeValues(const Diagnosis& diagnosis) {
  const auto is = [](const Alternative& other) { return other.verdict == Verdict::parameter_error; };
  return diagnosis.answer.verdict == Verdict::parameter_error ||
         std::any_of(diagnosis.answer.alternatives.begin(), diagnosis.answer.alternatives.end(), is);
}

struct Case {
  const char* effect;
  const char* model;
  const char* entry;
};

class BothShow : public testing::TestWithParam<Case> {};

TEST_P(BothShow, TheSameEffectInATableAndInLogs) {
  const auto& [effect, model, entry] = GetParam();
  const io::ComponentDescription truth = with(model, entry);
  const Diagnosis by_table = checkedTable(without(model), Laboratory(1).table(truth));
  const Diagnosis by_logs = checkedDiagnosis(without(model), logsOf(truth), {});
  EXPECT_THAT(listed(by_table), Contains(effect)) << by_table.sentence;
  EXPECT_THAT(listed(by_logs), Contains(effect)) << by_logs.sentence;
  EXPECT_EQ(by_table.answer.effects.size(), 1U) << by_table.sentence;
  EXPECT_GT(by_table.gaps.closed, 0.8);
}

INSTANTIATE_TEST_SUITE_P(
    Effects, BothShow,
    testing::Values(Case{"friction", kZener, kFriction},
                    Case{"relaxation", kZener, "{type: maxwell, stiffness: 6.0e5, break_frequency: 0.5}"},
                    Case{"viscous_damping", kZener, "{type: dashpot, damping: 3000}"},
                    Case{"progressive_stiffness", kZener, "{type: progressive_stiffness, cubic: 1.0e11}"},
                    Case{"bump_stop", kZener, "{type: bump_stop, stiffness: 2.0e6, gap: 1.2e-3}"},
                    Case{"free_play", kZener, "{type: free_play, gap: 3.0e-5}"},
                    Case{"inertia", kZener, "{type: inertia, mass: 60}"},
                    Case{"rate_amplitude_coupling", kZener,
                         "{type: nonlinear_maxwell, stiffness: 1.5e6, break_frequency: 3, displacement: 2.0e-4}"}),
    [](const auto& test) { return std::string(test.param.effect); });

// In a linear model, other values can imitate a series compliance, so the test also accepts wrong values.
TEST(TableDiagnosis, FindsASeriesCompliance) {
  const Diagnosis found = checkedTable(
      without(kManyMaxwell), Laboratory(1).table(with(kManyMaxwell, "{type: series_compliance, stiffness: 3.0e7}")));
  EXPECT_TRUE(mayBe(found, "series_compliance") || mayBeValues(found)) << found.sentence;
}

TEST(TableDiagnosis, FindsNothingWhereNothingIsMissing) {
  for (const char* model : {kZener, kManyMaxwell}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      const Diagnosis found = checkedTable(without(model), Laboratory(seed).table(without(model)));
      EXPECT_EQ(found.answer.verdict, diagnosis::Verdict::none) << found.sentence;
      EXPECT_THAT(found.answer.effects, IsEmpty());
    }
  }
}

TEST(TableDiagnosis, TellsWrongValuesFromEffects) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Diagnosis found = checkedTable(without(kZener), Laboratory(seed).table(without(kZenerOff)));
    EXPECT_EQ(found.answer.verdict, diagnosis::Verdict::parameter_error) << found.sentence;
    // The tolerance is a few times the noise of the table divided by the square root of the number of rows.
    for (const SizedValue& size : found.law.model_sizes) {
      if (size.name == "static_stiffness") {
        EXPECT_NEAR(size.value, 1.1e6, 0.02 * 1.1e6);
      }
    }
  }
}

TEST(TableDiagnosis, FindsFrictionBesideWrongValues) {
  const Diagnosis found = checkedTable(without(kZener), Laboratory(2).table(with(kZenerOff, kFriction)));
  EXPECT_THAT(found.answer.effects, ElementsAre("friction")) << found.sentence;
}

// A factor of 1.5 on all forces is either a gain or values that are all off by that factor.
TEST(TableDiagnosis, TellsAGainOrWrongValues) {
  fit::MeasuredTable table = Laboratory(1).table(without(kZener));
  for (fit::TablePoint& point : table.points) {
    point.stiffness *= 1.5;
  }
  const Diagnosis found = checkedTable(without(kZener), table);
  EXPECT_TRUE(found.answer.verdict == Verdict::parameter_error ||
              found.answer.effects == std::vector<std::string>{"sensor_gain"})
      << found.sentence;
}

fit::MeasuredTable multiplied(const std::function<std::complex<double>(double frequency)>& factor) {
  fit::MeasuredTable table = Laboratory(1).table(without(kZener));
  for (fit::TablePoint& point : table.points) {
    const std::complex<double> stiffness = point.complexStiffness() * factor(point.frequency);
    point.stiffness = std::abs(stiffness);
    point.loss_angle = std::arg(stiffness);
  }
  return table;
}

// The mount resonates at 6 Hz, but its law differs from the fluid column of the candidate.
TEST(TableDiagnosis, NamesTheFluidOfAMount) {
  const Diagnosis found = checkedTable(without(kZener), multiplied([](double frequency) {
                                         const std::complex<double> x(0.0, frequency / 6.0);
                                         return 1.0 + 0.6 * x * x / (1.0 + 0.15 * x + x * x);
                                       }));
  EXPECT_THAT(listed(found), Contains("fluid_inertia")) << found.sentence;
}

// No listed effect raises the stiffness about 6 Hz without a loss.
TEST(TableDiagnosis, RefusesWhatIsNotInTheList) {
  const Diagnosis found =
      checkedTable(without(kZener), multiplied([](double frequency) {
                     return 1.0 + 0.6 * std::exp(-0.5 * std::pow(std::log(frequency / 6.0) / 0.4, 2));
                   }));
  EXPECT_THAT(found.answer.verdict, testing::AnyOf(diagnosis::Verdict::unknown, diagnosis::Verdict::partly))
      << found.sentence;
}

// About a preload, a spring with an odd law also has an even part.
TEST(TableDiagnosis, TakesRowsAboutMeanDisplacements) {
  const component::Component truth = with(kZener, "{type: progressive_stiffness, cubic: 3.0e10}").makeComponent();
  Laboratory laboratory(1);
  fit::MeasuredTable table{"lab", {}, {}};
  for (const double mean : {0.0, 2e-3, 4e-3}) {
    for (const double amplitude : {2e-4, 5e-4}) {
      for (const double frequency : {1.0, 4.0, 16.0}) {
        table.points.push_back(laboratory.measured(pointOf(truth, frequency, amplitude, mean)));
      }
    }
  }
  const Diagnosis found = checkedTable(without(kZener), table);
  EXPECT_THAT(listed(found), Contains("progressive_stiffness")) << found.sentence;
  EXPECT_GT(found.gaps.unseen.as_configured, 0.3);
  EXPECT_LT(found.gaps.unseen.augmented, 0.03);
}

TEST(TableDiagnosis, FollowsTheTemperatureOfRows) {
  const std::string elements =
      "{model: elements, elements: [{type: spring, stiffness: 1.0e6}, "
      "{type: maxwell, stiffness: 6.0e5, break_frequency: 3.0}]";
  Laboratory laboratory(1);
  fit::MeasuredTable table{"lab", {}, {}};
  for (const double temperature : {0.0, 20.0, 40.0}) {
    // An activation energy of 40 kJ/mol shifts the break frequency of the component relative to 20 degC.
    constexpr double kGas = 8.314462618;
    const double shift = std::exp(4e4 / kGas * (1.0 / 293.15 - 1.0 / (273.15 + temperature)));
    const component::Component component({spring(1e6), maxwell(6e5, 3.0 * shift)});
    for (const double frequency : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
      fit::TablePoint point = laboratory.measured(pointOf(component, frequency, 5e-4));
      point.temperature = temperature;
      table.points.push_back(point);
    }
  }
  const Diagnosis found = checkedTable(bush(elements + "}"), table);
  EXPECT_THAT(found.answer.effects, ElementsAre("temperature")) << found.sentence;
  EXPECT_LT(found.gaps.unseen.augmented, 0.02);
}

// The diagnosis must not depend on the scale of time or force.
TEST(TableDiagnosis, OfASlowerAndSofterComponentIsTheSame) {
  constexpr double kSofter = 1e-3;
  const char* const slow =
      "{model: maxwell, specification: {static_stiffness: 1.0e3, dynamic_stiffness: 1.3e3, nominal_frequency: 0.04, "
      "break_frequency: 0.03}";
  const Diagnosis one = checkedTable(without(kZener), Laboratory(5).table(with(kZener, kFriction)));
  const Diagnosis other = checkedTable(
      without(slow), Laboratory(5).table(with(slow, "{type: friction, maximum_force: 0.2, displacement: 4.0e-4}"),
                                         {0.005, 0.01, 0.02, 0.04, 0.08, 0.16}));
  EXPECT_EQ(one.answer.effects, other.answer.effects);
  EXPECT_EQ(one.answer.verdict, other.answer.verdict);
  EXPECT_NEAR(one.gaps.unseen.augmented, other.gaps.unseen.augmented, 1e-4);  // limited by the iteration
  EXPECT_NEAR(one.law.model_sizes.back().value * kSofter, other.law.model_sizes.back().value,
              1e-3 * other.law.model_sizes.back().value);
}

}  // namespace
}  // namespace rubber_suspension::diagnosis
