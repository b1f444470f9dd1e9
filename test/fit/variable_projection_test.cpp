// Fits of random models: small residuals, intervals that contain the true values, equal bits on any processor.
#include "rubber_suspension/fit/identification.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/processor/instructions.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

// Returns sines of growing amplitude at a constant rate, with stamps in whole microseconds and a gap in the middle.
log::Log motion(int samples, std::int64_t step, double phase, std::int64_t gap = 0) {
  log::Log log = logOf("", samples, step, [](int /*i*/) { return 0.0; });
  for (std::size_t i = 0; i < log.size(); ++i) {
    log.stamp[i] = (log.stamp[i] + (i < log.size() / 2 ? 0 : gap)) / 1000 * 1000;
    const double t = 1e-9 * static_cast<double>(log.stamp[i]);
    log.displacement[i] = (0.4e-3 + 0.2e-3 * t) * std::sin(2.0 * element::kPi * 0.7 * t + phase) +
                          0.3e-3 * std::sin(2.0 * element::kPi * 5.3 * t) +
                          0.05e-3 * std::sin(2.0 * element::kPi * 17.0 * t);
  }
  return log;
}

// Simulates elements, and adds an offset and white noise relative to the range of the force.
void measure(const Entries& elements, double noise, std::mt19937& random, log::Log& measurement) {
  measurement.force = gap::simulateLog(component::Component(elements), measurement);
  const auto [low, high] = std::minmax_element(measurement.force.begin(), measurement.force.end());
  std::normal_distribution<double> normal(50.0, noise * (*high - *low));
  for (double& force : measurement.force) {
    force += normal(random);
  }
}

// Fits from a single start, because the best of several may have its Maxwell elements in another order.
fit::Identification fit(const Entries& elements, const std::vector<log::Log>& measurements,
                        const std::vector<std::string>& held = {}) {
  fit::IdentificationOptions options;
  options.starts = 1;
  options.held = held;
  return fit::identify(elements, measurements, options);
}

// Returns the RMS residual of the elements after subtraction of the mean over all logs.
double residualOf(const Entries& elements, const std::vector<log::Log>& measurements) {
  double sum = 0.0;
  double squares = 0.0;
  double count = 0.0;
  for (const log::Log& measurement : measurements) {
    const std::vector<double> force = gap::simulateLog(component::Component(elements), measurement);
    for (std::size_t i = 0; i < force.size(); ++i) {
      const double residual = measurement.force[i] - force[i];
      sum += residual;
      squares += residual * residual;
      count += 1.0;
    }
  }
  return std::sqrt(squares / count - std::pow(sum / count, 2));
}

class RandomModel {
 public:
  explicit RandomModel(unsigned seed) : random_(seed) {
    chooseElements();
    const int logs = chance() ? 1 : 2;
    const double noise = std::pow(10.0, between(-6.0, -1.0));
    for (int i = 0; i < logs; ++i) {
      addLog((1 + i) * 4000000, noise);
    }
    guess = truth;
    for (element::ElementDescription& element : guess) {
      for (auto& [name, values] : element.values) {
        values[0] *= name == "dead_band" ? 1.0 : between(0.5, 2.0);
      }
    }
  }

  Entries truth;
  Entries guess;
  std::vector<log::Log> measurements;

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance() { return between(0.0, 1.0) < 0.5; }

  // Each draw is a statement of its own, because the order in which arguments of a call are evaluated is not defined.
  void chooseElements() {
    truth.push_back(spring(between(1e6, 5e6)));
    if (chance()) {
      truth.push_back(dashpot(between(1e3, 1e4)));
    }
    const int maxwells = static_cast<int>(between(0.0, 3.99));
    for (int i = 0; i < maxwells; ++i) {
      const double stiffness = between(2e5, 1e6);
      truth.push_back(maxwell(stiffness, between(0.7, 1.5) * 0.3 * std::pow(10.0, i)));
    }
    if (chance()) {
      const double maximum_force = between(200.0, 2000.0);
      const double displacement = between(1e-4, 1e-3);
      truth.push_back(friction(maximum_force, displacement, chance() ? 3e-5 : 0.0));
    }
  }

  void addLog(std::int64_t step, double noise) {
    const int samples = static_cast<int>(between(600.0, 1500.0));
    step += chance() ? 1300 : 0;
    const std::int64_t gap = chance() ? 0 : 20 * step;
    measurements.push_back(motion(samples, step, between(0.0, 3.0), gap));
    measure(truth, noise, random_, measurements.back());
  }

  std::mt19937 random_;
};

constexpr double kSameResidual = 1e-8;  // relative difference

TEST(VariableProjection, LeavesNoMoreThanTheTruthOverRandomModels) {
  const unsigned models = 60;
  unsigned at_best = 0;
  unsigned parameters = 0;
  unsigned inside = 0;
  for (unsigned seed = 1; seed <= models; ++seed) {
    SCOPED_TRACE(seed);
    const RandomModel model(seed);
    const fit::Identification result = fit(model.guess, model.measurements);
    at_best += result.residual <= residualOf(model.truth, model.measurements) * (1.0 + kSameResidual) ? 1 : 0;
    for (const fit::IdentifiedParameter& parameter : result.parameters) {
      if (parameter.determined && result.elements.size() == model.truth.size()) {
        const double truth = model.truth[static_cast<std::size_t>(parameter.index)].value(parameter.name);
        ++parameters;
        inside += parameter.lower <= truth && truth <= parameter.upper ? 1 : 0;
      }
    }
  }
  // A search from a single start may end at a local optimum.
  EXPECT_GE(at_best, models * 9 / 10);
  // The intervals are of 95 %. Maxwell elements that swapped places are compared with the wrong element.
  EXPECT_GE(inside, parameters * 85 / 100);
  EXPECT_GE(parameters, 3 * models);
}

// If residuals are correlated in time, intervals are wider than for white noise of the same size.
TEST(VariableProjection, WidensIntervalsWhereResidualsAreCorrelated) {
  std::mt19937 random(3);
  const Entries truth = {spring(3e6), maxwell(5e5, 1.2), maxwell(4e5, 11.0), friction(900.0, 4e-4)};
  log::Log measurement = motion(2000, 2000000, 0.3);
  measure(truth, 1e-3, random, measurement);
  std::vector<double>& force = measurement.force;
  for (std::size_t i = 2; i < force.size(); ++i) {
    force[i] += 20.0 * std::sin(0.05 * static_cast<double>(i)) + 5.0 * std::normal_distribution<double>()(random);
  }
  const Entries guess = {spring(2e6), maxwell(5e5, 2.0), maxwell(4e5, 5.0), friction(500.0, 2e-4)};
  const fit::Identification result = fit(guess, {measurement});
  EXPECT_LT(result.independent_samples, 1500.0);
  EXPECT_LE(result.residual, residualOf(truth, {measurement}) * (1.0 + kSameResidual));
  for (const fit::IdentifiedParameter& parameter : result.parameters) {
    const double value = truth[static_cast<std::size_t>(parameter.index)].value(parameter.name);
    EXPECT_LE(parameter.lower, value) << parameter.element << "." << parameter.name;
    EXPECT_GE(parameter.upper, value) << parameter.element << "." << parameter.name;
  }
}

TEST(VariableProjection, KeepsHeldParametersOverLogs) {
  std::mt19937 random(5);
  const Entries truth = {spring(3e6), dashpot(3e3), maxwell(5e5, 1.2), maxwell(5e5, 9.0), friction(900.0, 4e-4, 2e-5)};
  std::vector<log::Log> measurements = {motion(1201, 2000000, 0.3), motion(903, 5000000, 1.0)};
  for (log::Log& measurement : measurements) {
    measure(truth, 0.01, random, measurement);
  }
  Entries guess = truth;
  guess[1] = dashpot(1e3);
  for (const std::vector<std::string>& held : {std::vector<std::string>{"maxwell.break_frequency"},
                                               {"maxwell.stiffness", "friction.maximum_force"},
                                               {"friction.displacement", "spring.stiffness"}}) {
    SCOPED_TRACE(held.front());
    const fit::Identification result = fit(guess, measurements, held);
    EXPECT_LE(result.residual, residualOf(truth, measurements) * (1.0 + kSameResidual));
    for (const std::string& name : held) {
      EXPECT_TRUE(std::none_of(result.parameters.begin(), result.parameters.end(), [&](const auto& parameter) {
        return parameter.element + "." + parameter.name == name;
      })) << name;
    }
  }
}

TEST(VariableProjection, LeavesOutWhatIsNotThere) {
  std::mt19937 random(7);
  log::Log measurement = motion(1500, 2000000, 0.0);
  const Entries truth = {spring(3e6), maxwell(5e5, 2.0), friction(900.0, 4e-4)};
  measure(truth, 1e-3, random, measurement);
  for (std::size_t i = 1; i < measurement.force.size(); ++i) {  // energy that a Maxwell element cannot add
    measurement.force[i] -= 2e3 * (measurement.displacement[i] - measurement.displacement[i - 1]) / 2e-3;
  }
  const Entries guess = {spring(2e6), dashpot(1e3), maxwell(5e5, 2.0), maxwell(5e5, 50.0), friction(500.0, 5e-4)};
  const fit::Identification result = fit(guess, {measurement});
  EXPECT_THAT(result.notes, testing::Contains(testing::HasSubstr("dashpot 2 has no force in the fit")));
  EXPECT_LE(result.residual, residualOf(truth, {measurement}) * (1.0 + kSameResidual));
}

TEST(VariableProjection, EndsAtALimit) {
  // The fit searches no break frequency above half of the sampling rate of 500 Hz.
  std::mt19937 random(7);
  log::Log measurement = motion(1500, 2000000, 0.0);
  measure({spring(3e6), maxwell(3e6, 1e3), friction(900.0, 4e-4)}, 1e-5, random, measurement);
  const Entries guess = {spring(2e6), maxwell(5e5, 20.0), friction(500.0, 5e-4)};
  const fit::Identification result = fit(guess, {measurement});
  const double highest = 0.5 * 500.0;
  EXPECT_NEAR(result.elements.at(1).value("break_frequency"), highest, 1e-9 * highest);
  const auto frequency = std::find_if(result.parameters.begin(), result.parameters.end(),
                                      [](const auto& parameter) { return parameter.name == "break_frequency"; });
  ASSERT_NE(frequency, result.parameters.end());
  EXPECT_FALSE(frequency->determined);
  // The other parameters are optimal: they agree with a fit whose break frequency is fixed at the limit.
  const fit::Identification held =
      fit({spring(2e6), maxwell(5e5, highest), friction(500.0, 5e-4)}, {measurement}, {"maxwell.break_frequency"});
  EXPECT_NEAR(result.residual / held.residual, 1.0, 1e-6);
}

TEST(VariableProjection, SameBitsOnAnyProcessor) {
  const RandomModel model(4);
  const fit::Identification widest = fit::identify(model.guess, model.measurements);
  for (const processor::Instructions instructions : {processor::Instructions::any, processor::Instructions::avx2}) {
    processor::useAtMost(instructions);
    const fit::Identification result = fit::identify(model.guess, model.measurements);
    processor::useAtMost(processor::Instructions::avx512);
    EXPECT_EQ(result.residual, widest.residual);
    ASSERT_EQ(result.parameters.size(), widest.parameters.size());
    for (std::size_t i = 0; i < result.parameters.size(); ++i) {
      EXPECT_EQ(result.parameters[i].value, widest.parameters[i].value);
      EXPECT_EQ(result.parameters[i].upper, widest.parameters[i].upper);
    }
  }
}

}  // namespace
}  // namespace rubber_suspension
