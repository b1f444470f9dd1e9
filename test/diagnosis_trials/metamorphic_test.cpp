// Verdict and probabilities do not change with other units, a turned, faster or larger bench, or another order of logs.
#include "diagnosis/judge/numbers.h"
#include "diagnosis/shared_runs.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

// Factors of length, force and time to other units or to another bench of the same kind.
struct Scale {
  double length = 1.0;
  double force = 1.0;
  double time = 1.0;
};

// Returns a force that decreases with the logarithm of time from 0.5 s on, by two elements per decade.
RigEffect creep() {
  return ofSteps([force = std::array<double, 5>{}](double step) mutable {
    double sum = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      force[i] = force[i] * std::exp(-0.004 / std::array{0.9, 2.8, 9.0, 28.0, 90.0}[i]) + 1e5 * step;
      sum += force[i];
    }
    return sum;
  });
}

log::Log scaled(log::Log log, const Scale& scale) {
  for (std::size_t i = 0; i < log.stamp.size(); ++i) {
    log.stamp[i] = static_cast<std::int64_t>(static_cast<double>(log.stamp[i]) * scale.time);
    log.displacement[i] *= scale.length;
    log.force[i] *= scale.force;
  }
  return log;
}

io::ComponentDescription scaled(io::ComponentDescription component, const Scale& scale) {
  estimation::Specification specification = component.specification();
  for (const char* key : {"static_stiffness", "dynamic_stiffness"}) {
    specification.set(key, *specification.find(key) * scale.force / std::abs(scale.length));
  }
  for (const char* key : {"nominal_frequency", "break_frequency"}) {
    specification.set(key, *specification.find(key) / scale.time);
  }
  component.specify(specification);
  return component;
}

std::vector<log::Log> logsOf(const RigEffect& effect) {
  return {runRig("one", 1, effect), runRig("two", 2, effect), runRig("three", 4, effect)};
}

diagnosis::Diagnosis diagnoseScaled(const RigEffect& effect, const Scale& scale) {
  std::vector<log::Log> logs;
  for (const log::Log& log : logsOf(effect)) {
    logs.push_back(scaled(log, scale));
  }
  return checkedDiagnosis(scaled(rigComponent(), {std::abs(scale.length), std::abs(scale.force), scale.time}), logs,
                          {scaled(runRig("unseen", 3, effect), scale)});
}

/// Returns the diagnosis of the unchanged bench, which is run once per test program.
const diagnosis::Diagnosis& reference(const std::string& bench, const RigEffect& effect) {
  static std::map<std::string, diagnosis::Diagnosis> runs;
  const auto known = runs.find(bench);
  return known != runs.end() ? known->second : runs.emplace(bench, diagnoseScaled(effect, {})).first->second;
}

std::map<std::string, double> probabilities(const diagnosis::Diagnosis& diagnosis) {
  std::map<std::string, double> result{{"none", diagnosis.answer.posterior.none},
                                       {"parameter_error", diagnosis.answer.posterior.parameter_error},
                                       {"none of these", diagnosis.answer.posterior.none_of_these}};
  for (const diagnosis::CandidateResult& candidate : diagnosis.candidates) {
    result[candidate.effect] = candidate.probability;
  }
  return result;
}

void expectTheSame(const diagnosis::Diagnosis& one, const diagnosis::Diagnosis& other) {
  EXPECT_EQ(one.answer.verdict, other.answer.verdict) << other.sentence;
  EXPECT_EQ(one.answer.effects, other.answer.effects) << other.sentence;
  EXPECT_NEAR(one.gaps.unseen.as_configured, other.gaps.unseen.as_configured, 0.01 * one.gaps.unseen.as_configured);
  EXPECT_NEAR(one.gaps.unseen.noise_floor, other.gaps.unseen.noise_floor, 0.05 * one.gaps.unseen.noise_floor);
  const auto expected = probabilities(one);
  const auto found = probabilities(other);
  ASSERT_EQ(expected.size(), found.size());
  for (const auto& [effect, probability] : expected) {
    EXPECT_NEAR(found.at(effect), probability, 0.01) << effect;
  }
}

struct Case {
  std::string name;
  RigEffect effect;
};

void PrintTo(const Case& bench, std::ostream* stream) { *stream << bench.name; }

class Metamorphic : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Benches, Metamorphic,
                         testing::Values(Case{"nothing", nothing}, Case{"stop", linearStop},
                                         Case{"friction", rigFriction()}, Case{"creep", creep()}));

TEST_P(Metamorphic, LengthForceAndTimeScale) {
  const diagnosis::Diagnosis& as_it_is = reference(GetParam().name, GetParam().effect);
  for (const Scale& scale : {Scale{0.01, 1.0, 1.0}, Scale{100.0, 1.0, 1.0}, Scale{1.0, 0.001, 1.0},
                             Scale{1.0, 1000.0, 1.0}, Scale{1.0, 1.0, 1.0 / 30.0}, Scale{1.0, 1.0, 100.0}}) {
    SCOPED_TRACE(testing::Message() << "length " << scale.length << ", force " << scale.force << ", time "
                                    << scale.time);
    expectTheSame(as_it_is, diagnoseScaled(GetParam().effect, scale));
  }
}

// Both channels change sign if the test piece is pulled instead of pushed.
TEST_P(Metamorphic, PulledTheOtherWayItIsTheSame) {
  expectTheSame(reference(GetParam().name, GetParam().effect), diagnoseScaled(GetParam().effect, {-1.0, -1.0, 1.0}));
}

// None of these effects remembers an earlier log, so the order of the logs has no influence.
TEST_P(Metamorphic, TheOrderOfLogsDoesNotMatter) {
  const std::vector<log::Log> logs = logsOf(GetParam().effect);
  const log::Log unseen = runRig("unseen", 3, GetParam().effect);
  expectTheSame(reference(GetParam().name, GetParam().effect),
                checkedDiagnosis(rigComponent(), {logs[2], logs[0], logs[1]}, {unseen}));
}

log::Log part(const log::Log& log, std::size_t begin, std::size_t end, const std::string& name) {
  log::Log result;
  result.name = name;
  for (std::size_t i = begin; i < end; ++i) {
    result.stamp.push_back(log.stamp[i]);
    result.displacement.push_back(log.displacement[i]);
    result.force.push_back(log.force[i]);
  }
  return result;
}

// Returns true if the residual beyond the noise that re-estimated values leave is small enough to accept the values.
bool isHidden(const diagnosis::Gap& gap) {
  const double accepted = diagnosis::judge::fittedNumbers().accepted;
  return gap.re_estimated * gap.re_estimated < gap.noise_floor * gap.noise_floor + accepted * accepted;
}

// The second half of a log starts in motion with an unknown past, so less of it is used. The verdict is the same, but
// probabilities differ. Re-estimated values may then hide creep, whose relaxation times are longest.
TEST_P(Metamorphic, LogsInTwoHalvesTellTheSame) {
  std::vector<log::Log> halves;
  for (const log::Log& log : logsOf(GetParam().effect)) {
    const std::size_t middle = log.stamp.size() / 2;
    halves.push_back(part(log, 0, middle, log.name + "_first"));
    halves.push_back(part(log, middle, log.stamp.size(), log.name + "_second"));
  }
  const diagnosis::Diagnosis& whole = reference(GetParam().name, GetParam().effect);
  const diagnosis::Diagnosis split = checkedDiagnosis(rigComponent(), halves, {runRig("unseen", 3, GetParam().effect)});
  if (GetParam().name == "creep" && isHidden(split.gaps.unseen)) {
    return;
  }
  EXPECT_EQ(whole.answer.verdict, split.answer.verdict) << split.sentence;
  EXPECT_EQ(whole.answer.effects, split.answer.effects) << split.sentence;
}

}  // namespace
}  // namespace rubber_suspension
