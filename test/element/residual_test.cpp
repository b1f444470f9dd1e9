// The surrogate: closed forms of each operator, bounds, and refused parameters.
#include "rubber_suspension/element/residual.h"

#include "element/typical_elements.h"
#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

using element::Residual;
using element::ResidualBasis;

constexpr double kDt = 1e-3;      // [s]
constexpr double kStroke = 4e-3;  // [m]
constexpr auto kProducts = static_cast<Eigen::Index>(ResidualBasis::kStates * ResidualBasis::kFactors);

ResidualBasis::Layout typicalLayout() {
  ResidualBasis::Layout layout;
  layout.stroke = kStroke;
  layout.lowest = -kStroke;
  layout.highest = kStroke;
  layout.stops = {0.02, 0.05, 0.1, 0.2, 0.4, 0.7};
  layout.times = {4e-3, 0.03, 0.25, 2.0};
  layout.amplitude_time = 0.3;
  layout.resonant = true;
  layout.frequencies = {1.0, 1.6, 2.5, 4.0, 6.0, 10.0, 16.0, 25.0};
  layout.points = 9;
  return layout;
}

/// Moves a basis of the surrogate along straight lines, from rest at zero.
class Moving {
 public:
  explicit Moving(const ResidualBasis::Layout& layout) : basis_(layout), memory_(ResidualBasis::kMemorySize) {
    basis_.initialise(0.0, memory_.data());
  }

  void moveTo(double displacement, double duration, int steps) {
    const double start = displacement_;
    for (int i = 1; i <= steps; ++i) {
      const double next = start + (displacement - start) * i / steps;
      basis_.advance({duration / steps, next, next - displacement_}, memory_.data());
      displacement_ = next;
    }
  }

  double operator[](std::size_t slot) const { return memory_[slot]; }

  Eigen::VectorXd values() const {
    Eigen::VectorXd result(basis_.size());
    basis_.evaluate(memory_.data(), result);
    return result;
  }

 private:
  ResidualBasis basis_;
  std::vector<double> memory_;
  double displacement_ = 0.0;
};

TEST(ResidualBasis, AStopFollowsUpToItsWidthAndBackAtOnce) {
  Moving moving(typicalLayout());
  moving.moveTo(0.5 * kStroke, 0.1, 100);
  EXPECT_DOUBLE_EQ(moving[ResidualBasis::kStop + 3], 0.2);
  EXPECT_NEAR(moving[ResidualBasis::kStop + 5], 0.5, 1e-14);
  moving.moveTo(0.4 * kStroke, 0.1, 100);
  EXPECT_NEAR(moving[ResidualBasis::kStop + 3], 0.1, 1e-14);
  EXPECT_DOUBLE_EQ(moving[ResidualBasis::kStop], -0.02);
}

// A ramp of speed v gives v tau (1 - exp(-t/tau)). Steps of dt have an error of (dt/tau)^2/6 of the decaying part, at
// most 1e-4 for the smallest tau.
TEST(ResidualBasis, ARelaxingShareIsThatOfAMaxwellElement) {
  Moving moving(typicalLayout());
  moving.moveTo(kStroke, 0.2, 2000);
  const auto layout = typicalLayout();
  for (std::size_t j = 0; j < ResidualBasis::kRelaxing; ++j) {
    const double tau = layout.times[j];
    EXPECT_NEAR(moving[ResidualBasis::kRelaxed + j], 5.0 * tau * (1.0 - std::exp(-0.2 / tau)), 1e-4 * 5.0 * tau) << tau;
  }
}

// The mean of |sin| is 2/pi. After 60 time constants of 0.3 s the start is forgotten. The leaky integrator passes 1/(2
// pi 20 Hz 0.3 s) = 2.7 % of the first harmonic of |sin|, which is two thirds of the mean.
TEST(ResidualBasis, TheAmplitudeIsTheMeanOfTheShare) {
  const ResidualBasis basis(typicalLayout());
  std::vector<double> memory(ResidualBasis::kMemorySize);
  basis.initialise(0.0, memory.data());
  double before = 0.0;
  for (int i = 1; i <= 18000; ++i) {
    const double z = 0.5 * kStroke * std::sin(2.0 * element::kPi * 10.0 * i * kDt);
    basis.advance({kDt, z, z - before}, memory.data());
    before = z;
  }
  EXPECT_NEAR(memory[ResidualBasis::kAmplitude], 1.0 / element::kPi, 0.03 / element::kPi);
}

// After a step, a resonator with damping ratio D = 0.15 rings as exp(-D w t) (cos w_d t + D/sqrt(1-D^2) sin w_d t).
// With steps of 0.1 ms, the trapezoidal rule has an error of 1e-3 after three periods of 40 ms. The displacement rises
// over one sample, which delays the ringing by half a sample.
TEST(ResidualBasis, AResonatorRingsAtItsFrequency) {
  Moving moving(typicalLayout());
  moving.moveTo(kStroke, 1e-4, 1);
  constexpr double kDampingRatio = 0.15;
  const double omega = 2.0 * element::kPi * 25.0;
  const double damped = omega * std::sqrt(1.0 - kDampingRatio * kDampingRatio);
  for (int i = 1; i <= 1200; ++i) {
    moving.moveTo(kStroke, 1e-4, 1);
    const double t = 1e-4 * (i + 0.5);
    const double decay = std::exp(-kDampingRatio * omega * t);
    const double velocity = decay * omega / damped * std::sin(damped * t);
    ASSERT_NEAR(moving[ResidualBasis::kVelocity + 7], velocity, 2e-3) << t;
    // Position x = q - (displacement of the mass), velocity v with v' = w x - 2 D w v.
    const double position = decay * (std::cos(damped * t) + kDampingRatio * omega / damped * std::sin(damped * t));
    ASSERT_NEAR(moving[ResidualBasis::kPosition + 7], position, 2e-3 + 0.008) << t;
  }
}

TEST(ResidualBasis, EvaluatesProductsHatsAndResonators) {
  Moving moving(typicalLayout());
  moving.moveTo(0.3 * kStroke, 0.05, 50);
  const Eigen::VectorXd values = moving.values();
  ASSERT_EQ(values.size(), kProducts + 9 + 16);
  EXPECT_NEAR(values[10 * 4 + 1], 0.09, 1e-14);       // q times q
  EXPECT_NEAR(values[3 * 4 + 2], 0.2 * 0.09, 1e-14);  // the fourth stop times q^2
  EXPECT_NEAR(values[10 * 4 + 3], 0.3 * moving[ResidualBasis::kAmplitude], 1e-14);
  // 0.3 lies between the points 0.25 and 0.5 of the hat functions. The value of the hat at zero is subtracted.
  EXPECT_NEAR(values[kProducts + 5], 0.8, 1e-12);
  EXPECT_NEAR(values[kProducts + 6], 0.2, 1e-12);
  EXPECT_NEAR(values[kProducts + 4], -1.0, 1e-12);
  EXPECT_DOUBLE_EQ(values[kProducts + 9], moving[ResidualBasis::kPosition]);
}

// The force of the written entry is the sum of weights times functions, with each function exactly once.
TEST(Residual, ItsForceIsTheWeightedSumOfTheFunctions) {
  const ResidualBasis basis(typicalLayout());
  Eigen::VectorXd weights(basis.size());
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    weights[i] = 100.0 * std::cos(1.0 + static_cast<double>(i * i));
  }
  WithState component({element::residualDescription(basis, weights, -1e6, 1e6)});
  Moving moving(typicalLayout());
  for (int i = 1; i <= 500; ++i) {
    const double z = kStroke * std::sin(0.02 * i) * std::cos(0.11 * i);
    moving.moveTo(z, kDt, 1);
    // The tolerance covers the rounding of sums of 69 products of some 100 N.
    ASSERT_NEAR(component.step(kDt, z), weights.dot(moving.values()), 1e-10) << i;
  }
}

TEST(Residual, StaysWithinItsForcesWhateverTheMotion) {
  element::ElementDescription law = typicalResidual();
  law.values["lowest_force"] = {-700.0};
  law.values["highest_force"] = {300.0};
  WithState component({law});
  double lowest = 0.0;
  double highest = 0.0;
  for (int i = 1; i <= 4000; ++i) {
    const double force = component.step(kDt, 0.5 * std::sin(0.3 * i) * std::sin(0.001 * i));
    lowest = std::min(lowest, force);
    highest = std::max(highest, force);
  }
  EXPECT_EQ(lowest, -700.0);
  EXPECT_EQ(highest, 300.0);
}

TEST(Residual, BeyondTheRangeItIsAsAtItsEnd) {
  WithState at_end({typicalResidual()});
  WithState beyond({typicalResidual()});
  for (int i = 1; i <= 300; ++i) {
    ASSERT_EQ(beyond.step(kDt, kStroke * (1.0 + 0.01 * i)), at_end.step(kDt, kStroke));
  }
}

// A diagnosis may write a surrogate without resonators.
TEST(Residual, RunsWithoutResonators) {
  element::ElementDescription law = typicalResidual();
  WithState with({law});
  for (double& weight : law.values["resonance_weights"]) {
    weight = 0.0;
  }
  WithState silent({law});
  law.values.erase("resonances");
  law.values.erase("resonance_weights");
  WithState without({law});
  for (int i = 1; i <= 100; ++i) {
    const double z = kStroke * std::sin(0.1 * i);
    const double force = without.step(kDt, z);
    ASSERT_NEAR(silent.step(kDt, z), force, 1e-9);  // sums have another order
    ASSERT_NE(with.step(kDt, z), force);
  }
}

std::string refusalOf(const std::string& parameter, const std::vector<double>& values) {
  element::ElementDescription law = typicalResidual();
  law.values[parameter] = values;
  return messageOf<std::invalid_argument>([&] { element::makeElement(law); });
}

TEST(Residual, RefusesWhatDoesNotFit) {
  const struct {
    std::string parameter;
    std::vector<double> values;
    std::string words;
  } rows[] = {
      {"stops", {0.1, 0.2}, "stops: has 2 values; accepted: 6"},
      {"weights", {1.0}, "weights: has 1 values; accepted: 44"},
      {"characteristic", {1.0}, "characteristic: has 1 values; accepted: at least 2"},
      {"resonances", {1.0}, "resonances: has 1 values; accepted: 8"},
      {"resonances", {0.0}, "resonance_weights: has 16 values, but there are no resonances; accepted: a single 0"},
      {"resonances", {1, 2, 3, 4, 5, 6, 7, 0}, "resonances: 0 Hz is out of range"},
      {"lowest", {1e-3}, "lowest: 0.001 m is out of range; accepted: at most 0"},
      {"lowest", {-1.0}, "lowest: -1 m is out of range; accepted: in [-0.004, 0]"},
      {"highest", {1.0}, "highest: 1 m is out of range; accepted: in ["},
      {"highest_force", {-1.0}, "highest_force: -1 N is out of range"}};
  for (const auto& row : rows) {
    EXPECT_THAT(refusalOf(row.parameter, row.values), HasSubstr("residual." + row.words)) << row.parameter;
  }
  element::ElementDescription law = typicalResidual();
  law.values["lowest"] = law.values["highest"] = {0.0};
  EXPECT_THROW(element::makeElement(law), std::invalid_argument) << "a range of nothing";
}

// All accepted values of the parameters give finite forces.
TEST(Residual, StaysFiniteAtTheEndsOfItsRanges) {
  element::ElementDescription law = typicalResidual();
  law.values["relaxation_times"] = {1e-9, 1e-9, 1.0, 1e30};
  law.values["amplitude_time"] = {1e-9};
  law.values["resonances"] = {1e9, 1e-100, 1.0, 1.0, 1.0, 1.0, 1.0, 1e9};
  law.values["stops"] = {1e-100, 1e30, 1.0, 1.0, 1.0, 1.0};
  law.values["weights"] = std::vector<double>(44, 1e30);
  WithState component({law});
  for (const double dt : {1e-9, 1e-3, 1e9}) {
    for (const double z : {1e300, -1e300, 0.0, 1e-3}) {
      const double force = component.step(dt, z);
      EXPECT_GE(force, -1e5);
      EXPECT_LE(force, 1e5);
    }
  }
  for (const double value : component.state.memory()) {
    EXPECT_TRUE(std::isfinite(value));
  }
}

}  // namespace
}  // namespace rubber_suspension::test
