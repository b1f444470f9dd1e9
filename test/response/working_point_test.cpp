// The working point of every model: what was asked for is what the loop has, over random specifications.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/estimation/specification.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension {
namespace {

constexpr double kLinearAccuracy = 1e-9;
constexpr double kFrictionAccuracy = 1e-6;
constexpr int kSpecifications = 300;

// Specifications of rubber springs of all sizes, fixed seed.
class RandomSpecifications {
 public:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

  estimation::Specification next() {
    estimation::Specification specification;
    const double k_st = logUniform(1e4, 1e8);
    specification.set("static_stiffness", k_st);
    specification.set("dynamic_stiffness", k_st * uniform(1.02, 2.5));
    specification.set("nominal_frequency", logUniform(0.1, 50.0));
    return specification;
  }

  void addAngle(estimation::Specification& specification, double largest) {
    const double angle = uniform(0.005, largest);
    if (uniform(0.0, 1.0) < 0.5) {
      specification.set("loss_angle", angle);
    } else {
      specification.set("relative_damping", 0.5 * std::tan(angle));
    }
  }

  // The largest loss angle that leaves storage stiffness above K_st.
  static double storageLimit(const estimation::Specification& specification) {
    return std::acos(specification.at("static_stiffness") / specification.at("dynamic_stiffness"));
  }

 private:
  std::mt19937 generator_{20150801};
};

double angleOf(const estimation::Specification& specification) {
  return specification.has("loss_angle") ? specification.at("loss_angle")
                                         : std::atan(2.0 * specification.at("relative_damping"));
}

response::SweepPoint atWorkingPoint(const std::vector<element::ElementDescription>& elements,
                                    const estimation::Specification& specification) {
  return response::characteristicsAt(component::Component(elements), specification.at("nominal_frequency"),
                                     specification.valueOr("nominal_amplitude", 1e-3));
}

void expectStiffness(const response::SweepPoint& point, const estimation::Specification& specification,
                     double accuracy) {
  EXPECT_NEAR(point.characteristics.stiffness / specification.at("dynamic_stiffness"), 1.0, accuracy);
}

void expectAngle(const response::SweepPoint& point, const estimation::Specification& specification, double accuracy) {
  EXPECT_NEAR(point.characteristics.loss_angle / angleOf(specification), 1.0, accuracy);
}

void expectStatic(const std::vector<element::ElementDescription>& elements,
                  const estimation::Specification& specification) {
  EXPECT_EQ(elements.at(0).type, "spring");
  EXPECT_EQ(elements.at(0).value("stiffness"), specification.at("static_stiffness"));
}

TEST(WorkingPoint, KelvinVoigt) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = random.next();
    random.addAngle(specification, 0.8);
    const auto elements = estimation::estimate(estimation::Model::kelvin_voigt, specification);
    const auto k = component::Component(elements).complexStiffness(specification.at("nominal_frequency")).value();
    // K_n is the storage stiffness of M1 (Eq. 11), not the magnitude.
    EXPECT_NEAR(k.real() / specification.at("dynamic_stiffness"), 1.0, kLinearAccuracy);
    EXPECT_NEAR(std::arg(k) / angleOf(specification), 1.0, kLinearAccuracy);
  }
}

TEST(WorkingPoint, MaxwellByBreakFrequency) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = random.next();
    specification.set("break_frequency", specification.at("nominal_frequency") * random.logUniform(1e-3, 30.0));
    const auto elements = estimation::estimate(estimation::Model::maxwell, specification);
    expectStatic(elements, specification);
    expectStiffness(atWorkingPoint(elements, specification), specification, kLinearAccuracy);
  }
}

TEST(WorkingPoint, MaxwellByLossAngle) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = random.next();
    random.addAngle(specification, 0.95 * RandomSpecifications::storageLimit(specification));
    const auto point = atWorkingPoint(estimation::estimate(estimation::Model::maxwell, specification), specification);
    expectStiffness(point, specification, kLinearAccuracy);
    expectAngle(point, specification, kLinearAccuracy);
  }
}

TEST(WorkingPoint, MaxwellByMaximumStiffness) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = random.next();
    specification.set("maximum_stiffness", specification.at("dynamic_stiffness") * random.uniform(1.01, 3.0));
    const auto elements = estimation::estimate(estimation::Model::maxwell, specification);
    expectStiffness(atWorkingPoint(elements, specification), specification, kLinearAccuracy);
    EXPECT_NEAR(
        (elements[0].value("stiffness") + elements[1].value("stiffness")) / specification.at("maximum_stiffness"), 1.0,
        kLinearAccuracy);
  }
}

TEST(WorkingPoint, MaxwellDashpot) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = random.next();
    random.addAngle(specification, 0.9 * RandomSpecifications::storageLimit(specification));
    const double angle = angleOf(specification);
    const double limit =
        specification.at("nominal_frequency") * specification.at("dynamic_stiffness") * std::sin(angle) /
        (specification.at("dynamic_stiffness") * std::cos(angle) - specification.at("static_stiffness"));
    specification.set("break_frequency", limit * random.logUniform(1e-3, 0.99));
    const auto point =
        atWorkingPoint(estimation::estimate(estimation::Model::maxwell_dashpot, specification), specification);
    expectStiffness(point, specification, kLinearAccuracy);
    expectAngle(point, specification, kLinearAccuracy);
  }
}

// The largest loss stiffness K_n sin(delta) of friction is 4/pi of its stiffness, that of Coulomb friction.
double frictionLimit(const estimation::Specification& specification) {
  const double ratio = specification.at("static_stiffness") / specification.at("dynamic_stiffness");
  return std::asin(std::min(0.95, 4.0 / element::kPi * (1.0 - ratio)));
}

TEST(WorkingPoint, Friction) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = random.next();
    specification.set("nominal_amplitude", random.logUniform(1e-5, 0.1));
    random.addAngle(specification, 0.95 * frictionLimit(specification));
    const auto elements = estimation::estimate(estimation::Model::friction, specification);
    expectStatic(elements, specification);
    const auto point = atWorkingPoint(elements, specification);
    EXPECT_TRUE(point.settled);
    expectStiffness(point, specification, kFrictionAccuracy);
    expectAngle(point, specification, kFrictionAccuracy);
  }
}

TEST(WorkingPoint, FrictionDashpot) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = random.next();
    specification.set("nominal_amplitude", random.logUniform(1e-5, 0.1));
    specification.set("viscous_share", random.uniform(0.0, 0.5));
    random.addAngle(specification, 0.95 * frictionLimit(specification));
    const auto elements = estimation::estimate(estimation::Model::friction_dashpot, specification);
    const double amplitude = specification.at("nominal_amplitude");
    const auto loop =
        response::simulateSettledLoop(component::Component(elements), specification.at("nominal_frequency"), amplitude);
    // K_n holds between the turning points, and the loss is that of a loop of K_n and the loss angle.
    const double between = (loop.force[loop.force.size() / 2] - loop.force[0]) / (2.0 * amplitude);
    EXPECT_NEAR(between / specification.at("dynamic_stiffness"), 1.0, kFrictionAccuracy);
    const double loss = element::kPi * specification.at("dynamic_stiffness") * amplitude * amplitude;
    EXPECT_NEAR(loop.characteristics().loss / (loss * std::sin(angleOf(specification))), 1.0, kFrictionAccuracy);
  }
}

TEST(WorkingPoint, Berg) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = random.next();
    specification.set("nominal_amplitude", random.logUniform(1e-5, 0.1));
    specification.set("viscous_share", random.uniform(0.0, 0.3));
    specification.set("break_frequency", specification.at("nominal_frequency") * random.logUniform(0.3, 3.0));
    random.addAngle(specification, 0.4 * frictionLimit(specification));
    const auto elements = estimation::estimate(estimation::Model::berg, specification);
    expectStatic(elements, specification);
    const auto point = atWorkingPoint(elements, specification);
    expectStiffness(point, specification, kFrictionAccuracy);
    expectAngle(point, specification, kFrictionAccuracy);
  }
}

// A specification that a randomly weighted bank of elements has, so that it has a solution.
estimation::Specification fiveInputs(RandomSpecifications& random) {
  while (true) {
    estimation::Specification specification = random.next();
    specification.set("maximum_stiffness", specification.at("dynamic_stiffness") * random.uniform(1.01, 2.0));
    specification.set("high_frequency", specification.at("nominal_frequency") * random.logUniform(1.5, 50.0));
    specification.set("maxwell_elements", std::floor(random.uniform(3.0, 9.0)));
    try {
      estimation::estimate(estimation::Model::multi_maxwell, specification);
      return specification;
    } catch (const std::invalid_argument&) {
      // No solution; its errors have a test of their own.
    }
  }
}

double sumOfStiffnesses(const std::vector<element::ElementDescription>& elements) {
  double sum = 0.0;
  for (const element::ElementDescription& element : elements) {
    sum += element.value("stiffness");
  }
  return sum;
}

TEST(WorkingPoint, MultiMaxwell) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    const estimation::Specification specification = fiveInputs(random);
    const auto elements = estimation::estimate(estimation::Model::multi_maxwell, specification);
    expectStatic(elements, specification);
    expectStiffness(atWorkingPoint(elements, specification), specification, kLinearAccuracy);
    EXPECT_NEAR(sumOfStiffnesses(elements) / specification.at("maximum_stiffness"), 1.0, kLinearAccuracy);
  }
}

TEST(WorkingPoint, MultiMaxwellWithLossAngleForMaximumStiffness) {
  RandomSpecifications random;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = fiveInputs(random);
    const auto five = estimation::estimate(estimation::Model::multi_maxwell, specification);
    const double k_max = specification.at("maximum_stiffness");
    specification.set("loss_angle", atWorkingPoint(five, specification).characteristics.loss_angle);
    specification.erase("maximum_stiffness");
    const auto elements = estimation::estimate(estimation::Model::multi_maxwell, specification);
    const auto point = atWorkingPoint(elements, specification);
    expectStiffness(point, specification, kLinearAccuracy);
    expectAngle(point, specification, kLinearAccuracy);
    // The solution is the only one, so the way there and back ends at the beginning; ill-conditioned where one element
    // carries nearly all.
    EXPECT_NEAR(sumOfStiffnesses(elements) / k_max, 1.0, 1e-6);
  }
}

TEST(WorkingPoint, MultiMaxwellWithLossAngleForHighFrequency) {
  RandomSpecifications random;
  int solved = 0;
  for (int i = 0; i < kSpecifications; ++i) {
    estimation::Specification specification = fiveInputs(random);
    const auto five = estimation::estimate(estimation::Model::multi_maxwell, specification);
    specification.set("loss_angle", atWorkingPoint(five, specification).characteristics.loss_angle);
    specification.erase("high_frequency");
    try {
      const auto elements = estimation::estimate(estimation::Model::multi_maxwell, specification);
      ++solved;
      const auto point = atWorkingPoint(elements, specification);
      expectStiffness(point, specification, kLinearAccuracy);
      expectAngle(point, specification, kLinearAccuracy);
      EXPECT_NEAR(sumOfStiffnesses(elements) / specification.at("maximum_stiffness"), 1.0, kLinearAccuracy);
    } catch (const std::invalid_argument&) {
      // The scan steps over pairs of solutions that lie closer than its step, near the lowest angle possible.
    }
  }
  EXPECT_GE(solved, kSpecifications * 9 / 10);
}

TEST(WorkingPoint, HighFrequencyOfTheExampleComesBack) {
  estimation::Specification specification;
  specification.set("static_stiffness", 3e6);
  specification.set("dynamic_stiffness", 4.2e6);
  specification.set("nominal_frequency", 4.0);
  specification.set("maximum_stiffness", 4.9e6);
  specification.set("high_frequency", 25.0);
  const auto five = estimation::estimate(estimation::Model::multi_maxwell, specification);
  specification.set("loss_angle", atWorkingPoint(five, specification).characteristics.loss_angle);
  specification.erase("high_frequency");
  const auto elements = estimation::estimate(estimation::Model::multi_maxwell, specification);
  for (std::size_t i = 1; i < five.size(); ++i) {
    EXPECT_NEAR(elements[i].value("break_frequency") / five[i].value("break_frequency"), 1.0, 1e-9);
    EXPECT_NEAR(elements[i].value("stiffness") / five[i].value("stiffness"), 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace rubber_suspension
