// Errors that benches add to logs, single and combined, at three sizes. None of them may be named as an effect, and the
// effects of the component are still named beside them.
#include <iostream>

#include "diagnosis/shared_runs.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

using Generator = std::mt19937;
using Fault = void (*)(log::Log& log, double size, Generator& generator);

double rangeOf(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

double deviationOf(const std::vector<double>& values) {
  double sum = 0.0;
  double square = 0.0;
  for (const double value : values) {
    sum += value;
    square += value * value;
  }
  const auto count = static_cast<double>(values.size());
  return std::sqrt(square / count - sum * sum / (count * count));
}

void shift(std::vector<double>& values, double by) {
  std::transform(values.begin(), values.end(), values.begin(), [by](double value) { return value + by; });
}

// Adds an offset of up to 3 % of its range to each channel, different in each log.
void zeros(log::Log& log, double size, Generator& generator) {
  std::uniform_real_distribution<double> uniform(-0.03 * size, 0.03 * size);
  shift(log.displacement, uniform(generator) * rangeOf(log.displacement));
  shift(log.force, uniform(generator) * rangeOf(log.force));
}

// Removes the first 5 % of the recording.
void runningStart(log::Log& log, double size, Generator& /*generator*/) {
  const auto cut = static_cast<std::ptrdiff_t>(0.05 * size * static_cast<double>(log.stamp.size()));
  log.stamp.erase(log.stamp.begin(), log.stamp.begin() + cut);
  log.displacement.erase(log.displacement.begin(), log.displacement.begin() + cut);
  log.force.erase(log.force.begin(), log.force.begin() + cut);
}

// Adds three spikes of the force, as from a bad contact.
void spikes(log::Log& log, double size, Generator& generator) {
  std::uniform_int_distribution<std::size_t> place(10, log.force.size() - 10);
  std::uniform_real_distribution<double> height(3.0, 10.0);
  const double deviation = deviationOf(log.force);
  const auto count = std::max(1, static_cast<int>(std::lround(3.0 * size)));
  for (int i = 0; i < count; ++i) {
    log.force[place(generator)] += (i % 2 == 0 ? 1.0 : -1.0) * height(generator) * deviation;
  }
}

// Adds 1/f noise of 0.5 % of the force: first-order processes an octave apart (van der Ziel, Physica 16, 1950).
void pink(log::Log& log, double size, Generator& generator) {
  std::normal_distribution<double> normal;
  std::vector<double> noise(log.force.size(), 0.0);
  for (double time = 1.0; time < static_cast<double>(noise.size()); time *= 2.0) {
    const double pole = std::exp(-1.0 / time);
    double state = normal(generator);
    for (double& value : noise) {
      state = pole * state + std::sqrt(1.0 - pole * pole) * normal(generator);
      value += state;
    }
  }
  const double scale = 0.005 * size * deviationOf(log.force) / deviationOf(noise);
  for (std::size_t i = 0; i < noise.size(); ++i) {
    log.force[i] += scale * noise[i];
  }
}

void gain(log::Log& log, double size, Generator& /*generator*/) {
  for (double& force : log.force) {
    force *= 1.0 + 0.003 * size;
  }
}

// Shifts the force up to a quarter of a sample, late in one log and early in the next. A common delay is an effect.
void delay(log::Log& log, double size, Generator& generator) {
  const double sign = log.name.back() % 2 == 0 ? 1.0 : -1.0;
  const double late = sign * std::uniform_real_distribution<double>(0.0, 0.25 * size)(generator);
  const std::vector<double> force = log.force;
  for (std::size_t i = 1; i + 1 < force.size(); ++i) {
    log.force[i] += std::abs(late) * (force[late > 0.0 ? i - 1 : i + 1] - force[i]);
  }
}

// Repeats a value in ten samples in a row, twice per log.
void held(log::Log& log, double size, Generator& generator) {
  std::uniform_int_distribution<std::size_t> place(100, log.force.size() - 100);
  for (int run = 0; run < 2; ++run) {
    const std::size_t begin = place(generator);
    for (std::size_t i = 1; i <= static_cast<std::size_t>(10.0 * size); ++i) {
      log.force[begin + i] = log.force[begin];
    }
  }
}

struct Axis {
  std::string name;
  std::vector<Fault> faults;
};

void PrintTo(const Axis& axis, std::ostream* stream) { *stream << axis.name; }

// Force of a bush that is stiffer in tension than in compression.
double asymmetric(double /*time*/, double z, double /*rate*/) { return z > 0.0 ? 2e5 * z : 0.0; }

log::Log recorded(unsigned seed, const RigEffect& effect, const Axis& axis, double size) {
  log::Log log = runRig("log" + std::to_string(seed), seed, effect);
  Generator generator(seed);
  for (const Fault fault : axis.faults) {
    fault(log, size, generator);
  }
  return log;
}

diagnosis::Diagnosis diagnoseBench(const RigEffect& effect, const Axis& axis, double size, unsigned draw) {
  std::vector<log::Log> logs;
  for (unsigned i = 0; i < 3; ++i) {
    logs.push_back(recorded(10 * draw + i, effect, axis, size));
  }
  return checkedDiagnosis(rigComponent(), logs, {recorded(10 * draw + 3, effect, axis, size)});
}

class BenchFaults : public testing::TestWithParam<Axis> {};

INSTANTIATE_TEST_SUITE_P(Axes, BenchFaults,
                         testing::Values(Axis{"none", {}}, Axis{"zeros", {zeros}},
                                         Axis{"running_start", {runningStart}}, Axis{"spikes", {spikes}},
                                         Axis{"pink", {pink}}, Axis{"gain", {gain}}, Axis{"delay", {delay}},
                                         Axis{"held", {held}},
                                         Axis{"together", {runningStart, zeros, pink, gain, delay, spikes, held}}));

TEST_P(BenchFaults, LeaveGapFreeLogsAloneAndEffectsTheirNames) {
  const Axis& axis = GetParam();
  const std::vector<double> all_sizes = {0.5, 1.0, 2.0};
  for (const double size : axis.faults.empty() ? std::vector<double>{1.0} : all_sizes) {
    SCOPED_TRACE(testing::Message() << "size " << size);
    const diagnosis::Diagnosis none = diagnoseBench(nothing, axis, size, 1);
    // A gain that all logs share is equivalent to wrong values of the model.
    const bool scaled = std::count(axis.faults.begin(), axis.faults.end(), gain) > 0;
    EXPECT_TRUE(none.answer.verdict == diagnosis::Verdict::none ||
                (scaled && none.answer.verdict == diagnosis::Verdict::parameter_error))
        << none.sentence;
    EXPECT_TRUE(none.answer.effects.empty());
    for (const auto& [effect, name] :
         {std::pair<RigEffect, std::string>{linearStop, "bump_stop"}, {asymmetric, "asymmetric_stiffness"}}) {
      const diagnosis::Diagnosis found = diagnoseBench(effect, axis, size, 2);
      EXPECT_EQ(found.answer.effects, std::vector<std::string>{name}) << found.sentence;
    }
  }
}

}  // namespace
}  // namespace rubber_suspension
