// Errors of stiffness, loss angle and energy of a model with known errors, at fast and slow sampling.
#include "diagnosis/results/characteristics.h"

#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr Eigen::Index kSineSamples = 20000;
constexpr double kStiffness = 1e6;

// Logs four sines of different frequencies, one after the other, on a spring and dashpot in parallel.
struct Measured {
  log::Record record;
  Eigen::VectorXd simulated;  // spring 10 % too soft, no dashpot

  explicit Measured(double dt) {
    record.name = "sines";
    record.dt = dt;
    record.displacement.resize(kSineSamples);
    record.force.resize(kSineSamples);
    double phase = 0.0;
    double mean = 0.0;
    for (Eigen::Index i = 0; i < kSineSamples; ++i) {
      const double step = 2.0 * element::kPi * 1e-3 * static_cast<double>(1 + 4 * i / kSineSamples);  // phase [rad]
      phase += step;
      mean += step / static_cast<double>(kSineSamples);
      record.displacement[i] = 1e-3 * std::sin(phase);
      record.force[i] = 1e-3 * kStiffness * (std::sin(phase) + 0.1 * std::cos(phase));
    }
    record.raw_displacement = record.displacement;
    record.mean_frequency = mean / (2.0 * element::kPi * dt);
    simulated = 0.9 * kStiffness * record.displacement;
  }

  diagnosis::CharacteristicErrors errors() const {
    return diagnosis::results::characteristicErrors({record}, {simulated});
  }
};

TEST(CharacteristicErrors, AreThoseOfTheModel) {
  const diagnosis::CharacteristicErrors errors = Measured(1e-3).errors();
  // Windows do not end at whole cycles, so each mixes up to 1 % of a neighbouring sine into its result.
  EXPECT_NEAR(errors.stiffness, 1.0 - 0.9 / std::hypot(1.0, 0.1), 0.01);
  EXPECT_NEAR(errors.loss_angle, std::atan(0.1), 0.01);
  EXPECT_NEAR(errors.energy, 1.0, 0.05);  // the simulated spring dissipates no energy
}

TEST(CharacteristicErrors, AreTheSameOfASlowerTest) {
  const diagnosis::CharacteristicErrors fast = Measured(1e-3).errors();
  // The factor between the two time steps is a power of two. It causes no rounding, so windows end at the same samples.
  const diagnosis::CharacteristicErrors slow = Measured(1024.0 * 1e-3).errors();
  EXPECT_EQ(fast.stiffness, slow.stiffness);
  EXPECT_EQ(fast.loss_angle, slow.loss_angle);
  EXPECT_EQ(fast.energy, slow.energy);
}

TEST(CharacteristicErrors, WithoutAMeanFrequencyTheWholeLogIsAWindow) {
  Measured whole(1e-3);
  whole.record.mean_frequency = 0.0;
  EXPECT_GT(whole.errors().stiffness, 0.05);
}

}  // namespace
}  // namespace rubber_suspension
