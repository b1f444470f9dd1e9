// Fits by products of columns against fits by residuals: the same optimum, intervals and notes, over random models.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/fit/identification.h"
#include "rubber_suspension/processor/instructions.h"

namespace rubber_suspension {
namespace {

element::ElementDescription spring(double stiffness) { return {"spring", {{"stiffness", {stiffness}}}}; }

element::ElementDescription dashpot(double damping) { return {"dashpot", {{"damping", {damping}}}}; }

element::ElementDescription maxwell(double stiffness, double break_frequency) {
  return {"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {break_frequency}}}};
}

element::ElementDescription friction(double maximum_force, double displacement, double dead_band) {
  return {"friction",
          {{"maximum_force", {maximum_force}}, {"displacement", {displacement}}, {"dead_band", {dead_band}}}};
}

// A log of sines of growing amplitude at a constant rate, its stamps rounded to microseconds, with a gap in the middle.
log::Log motion(std::size_t samples, std::int64_t step, double phase, std::int64_t gap = 0) {
  log::Log measurement;
  for (std::size_t i = 0; i < samples; ++i) {
    const std::int64_t stamp = static_cast<std::int64_t>(i) * step + (i < samples / 2 ? 0 : gap);
    measurement.stamp.push_back(stamp / 1000 * 1000);
    const double t = 1e-9 * static_cast<double>(measurement.stamp.back());
    measurement.displacement.push_back((0.4e-3 + 0.2e-3 * t) * std::sin(2.0 * element::kPi * 0.7 * t + phase) +
                                       0.3e-3 * std::sin(2.0 * element::kPi * 5.3 * t) +
                                       0.05e-3 * std::sin(2.0 * element::kPi * 17.0 * t));
  }
  return measurement;
}

// The force of elements, with an offset and white noise relative to the largest force.
void measure(const std::vector<element::ElementDescription>& elements, double noise, std::mt19937& random,
             log::Log& measurement) {
  const component::Component component(elements);
  component::SampleStream stream(component);
  measurement.force.resize(measurement.stamp.size());
  stream.pushAll(measurement.stamp.data(), measurement.displacement.data(), measurement.stamp.size(),
                 measurement.force.data());
  const auto [low, high] = std::minmax_element(measurement.force.begin(), measurement.force.end());
  std::normal_distribution<double> normal(50.0, noise * (*high - *low));
  for (double& force : measurement.force) {
    force += normal(random);
  }
}

constexpr double kSameResidual = 1e-8;  // relative

// From one start: of several, any may come first at an optimum that has Maxwell elements in another order.
fit::Identification fit(const std::vector<element::ElementDescription>& elements,
                        const std::vector<log::Log>& measurements, bool by_products,
                        const std::vector<std::string>& held = {}) {
  fit::IdentificationOptions options;
  options.starts = 1;
  options.held = held;
  options.by_products = by_products;
  return fit::identify(elements, measurements, options);
}

double width(const fit::IdentifiedParameter& parameter) { return parameter.upper - parameter.lower; }

// Both searches end where a step gains less than 1e-10 of the cost: within sqrt(1e-10 N), 0.4 thousandths of a standard
// deviation for N = 1500 samples, of the optimum where they converge fast; the interval has four standard deviations.
void expectSameParameters(const fit::Identification& expected, const fit::Identification& actual) {
  ASSERT_EQ(actual.parameters.size(), expected.parameters.size());
  for (std::size_t i = 0; i < expected.parameters.size(); ++i) {
    const fit::IdentifiedParameter& parameter = expected.parameters[i];
    SCOPED_TRACE(parameter.element + "." + parameter.name);
    EXPECT_EQ(actual.parameters[i].name, parameter.name);
    EXPECT_EQ(actual.parameters[i].index, parameter.index);
    EXPECT_EQ(actual.parameters[i].determined, parameter.determined);
    if (parameter.determined) {
      EXPECT_NEAR(actual.parameters[i].value, parameter.value, 2.5e-3 * width(parameter));
      EXPECT_NEAR(width(actual.parameters[i]) / width(parameter), 1.0, 1e-2);
    }
  }
}

void expectSame(const fit::Identification& expected, const fit::Identification& actual) {
  EXPECT_NEAR(actual.residual / expected.residual, 1.0, kSameResidual);
  EXPECT_NEAR(actual.independent_samples / expected.independent_samples, 1.0, 1e-3);
  EXPECT_EQ(actual.notes, expected.notes);
  EXPECT_EQ(actual.starts, expected.starts);
  EXPECT_EQ(actual.elements.size(), expected.elements.size());
  EXPECT_EQ(actual.undetermined.size(), expected.undetermined.size());
  expectSameParameters(expected, actual);
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

  std::vector<element::ElementDescription> truth;
  std::vector<element::ElementDescription> guess;
  std::vector<log::Log> measurements;

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance() { return between(0.0, 1.0) < 0.5; }

  // One draw a line: the order of those among the arguments of a call is the compiler's choice.
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
    const auto samples = static_cast<std::size_t>(between(600.0, 1500.0));
    step += chance() ? 1300 : 0;
    const std::int64_t gap = chance() ? 0 : 20 * step;
    measurements.push_back(motion(samples, step, between(0.0, 3.0), gap));
    measure(truth, noise, random_, measurements.back());
  }

  std::mt19937 random_;
};

TEST(ProductFit, AgreesWithResidualsOverRandomModels) {
  // Where the search by residuals comes to its end in a long valley, that by products goes on; parameters are compared
  // where both ended at the same residual, and that has to be the rule.
  const unsigned models = 60;
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= models; ++seed) {
    SCOPED_TRACE(seed);
    const RandomModel model(seed);
    const fit::Identification expected = fit(model.guess, model.measurements, false);
    const fit::Identification actual = fit(model.guess, model.measurements, true);
    EXPECT_LE(actual.residual, expected.residual * (1.0 + kSameResidual));
    if (actual.residual >= expected.residual * (1.0 - kSameResidual)) {
      expectSame(expected, actual);
      ++compared;
    }
  }
  EXPECT_GE(compared, models * 9 / 10);
}

// A log whose residuals are correlated in time, so that the covariance needs the derivatives themselves.
TEST(ProductFit, AgreesWhereResidualsAreCorrelated) {
  std::mt19937 random(3);
  const std::vector<element::ElementDescription> truth = {spring(3e6), maxwell(5e5, 1.2), maxwell(4e5, 11.0),
                                                          friction(900.0, 4e-4, 0.0)};
  log::Log measurement = motion(2000, 2000000, 0.3);
  measure(truth, 1e-3, random, measurement);
  std::vector<double>& force = measurement.force;
  for (std::size_t i = 2; i < force.size(); ++i) {
    force[i] += 20.0 * std::sin(0.05 * static_cast<double>(i)) + 5.0 * std::normal_distribution<double>()(random);
  }
  const std::vector<element::ElementDescription> guess = {spring(2e6), maxwell(5e5, 2.0), maxwell(4e5, 5.0),
                                                          friction(500.0, 2e-4, 0.0)};
  const fit::Identification expected = fit(guess, {measurement}, false);
  EXPECT_LT(expected.independent_samples, 1500.0);
  expectSame(expected, fit(guess, {measurement}, true));
}

TEST(ProductFit, AgreesOverLogsWithHeldParameters) {
  std::mt19937 random(5);
  const std::vector<element::ElementDescription> truth = {spring(3e6), dashpot(3e3), maxwell(5e5, 1.2),
                                                          maxwell(5e5, 9.0), friction(900.0, 4e-4, 2e-5)};
  std::vector<log::Log> measurements = {motion(1201, 2000000, 0.3), motion(903, 5000000, 1.0)};
  for (log::Log& measurement : measurements) {
    measure(truth, 0.01, random, measurement);
  }
  std::vector<element::ElementDescription> guess = truth;
  guess[1] = dashpot(1e3);
  for (const std::vector<std::string>& held : {std::vector<std::string>{"maxwell.break_frequency"},
                                               {"maxwell.stiffness", "friction.maximum_force"},
                                               {"friction.displacement", "spring.stiffness"}}) {
    SCOPED_TRACE(held.front());
    expectSame(fit(guess, measurements, false, held), fit(guess, measurements, true, held));
  }
}

TEST(ProductFit, AgreesOnWhatIsNotThere) {
  std::mt19937 random(7);
  log::Log measurement = motion(1500, 2000000, 0.0);
  measure({spring(3e6), maxwell(5e5, 2.0), friction(900.0, 4e-4, 0.0)}, 1e-3, random, measurement);
  for (std::size_t i = 1; i < measurement.force.size(); ++i) {  // energy that no Maxwell element can give
    measurement.force[i] -= 2e3 * (measurement.displacement[i] - measurement.displacement[i - 1]) / 2e-3;
  }
  const std::vector<element::ElementDescription> guess = {spring(2e6), dashpot(1e3), maxwell(5e5, 2.0),
                                                          maxwell(5e5, 50.0), friction(500.0, 5e-4, 0.0)};
  const fit::Identification expected = fit(guess, {measurement}, false);
  EXPECT_THAT(expected.notes, testing::Contains(testing::HasSubstr("dashpot 2 was left without force")));
  expectSame(expected, fit(guess, {measurement}, true));
}

TEST(ProductFit, AgreesAtALimit) {
  // Beyond half of the rate of 500 Hz no break frequency is searched.
  std::mt19937 random(7);
  log::Log measurement = motion(1500, 2000000, 0.0);
  measure({spring(3e6), maxwell(3e6, 1e3), friction(900.0, 4e-4, 0.0)}, 1e-5, random, measurement);
  const std::vector<element::ElementDescription> guess = {spring(2e6), maxwell(5e5, 20.0), friction(500.0, 5e-4, 0.0)};
  const fit::Identification expected = fit(guess, {measurement}, false);
  const auto frequency = [](const fit::Identification& result) {
    return result.elements.at(1).value("break_frequency");
  };
  const double highest = 0.5 * 500.0;
  EXPECT_NEAR(frequency(expected), highest, 1e-9 * highest);
  const fit::Identification actual = fit(guess, {measurement}, true);
  EXPECT_NEAR(frequency(actual), highest, 1e-9 * highest);
  // The search by residuals cuts its steps at limits, which makes the last ones short: it ends a little earlier.
  EXPECT_NEAR(actual.residual / expected.residual, 1.0, 1e-6);
  expectSameParameters(expected, actual);
}

TEST(ProductFit, FindsTheTruthInALogWithoutNoise) {
  std::mt19937 random(1);
  const std::vector<element::ElementDescription> truth = {spring(3e6), maxwell(5e5, 1.2), maxwell(4e5, 11.0),
                                                          friction(900.0, 4e-4, 0.0)};
  log::Log measurement = motion(1500, 2000000, 0.0);
  measure(truth, 0.0, random, measurement);
  const std::vector<element::ElementDescription> guess = {spring(2e6), maxwell(5e5, 2.0), maxwell(4e5, 5.0),
                                                          friction(500.0, 2e-4, 0.0)};
  const fit::Identification result = fit(guess, {measurement}, true);
  EXPECT_LT(result.relative_residual, 1e-8);
  EXPECT_NEAR(result.elements[1].value("break_frequency"), 1.2, 1e-6);
  EXPECT_NEAR(result.elements[3].value("displacement"), 4e-4, 1e-9);
}

TEST(ProductFit, SameBitsOnAnyProcessor) {
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
