// The surrogate predicts functions of the motion on logs to which it was not fitted, and predicts nothing else.
#include "fit/surrogate.h"

#include "gap/simulate.h"
#include "numerics/least_squares.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr double kStep = 2e-3;      // [s]
constexpr double kStiffness = 1e6;  // [N/m]
constexpr double kNoise = 20.0;     // [N]

/// Returns the force [N] that a spring lacks, for the displacements of a log [m].
using Missing = std::function<std::vector<double>(const std::vector<double>&)>;

/// Records 30 s of sines of 1 to 12 Hz, with slowly varying amplitudes up to 1.5 mm, on a spring that lacks a force.
log::Record record(unsigned seed, const Missing& missing) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, kNoise);
  std::uniform_real_distribution<double> uniform(0.0, 2.0 * element::kPi);
  const std::array<double, 4> phases = {uniform(generator), uniform(generator), uniform(generator), uniform(generator)};
  log::Log log;
  log.name = "log " + std::to_string(seed);
  for (int i = 0; i < 15000; ++i) {
    const double t = kStep * i;
    const double slow =
        (0.6 + 0.4 * std::sin(0.5 * t + phases[3])) * 1e-3 * std::sin(2.0 * element::kPi * t + phases[0]);
    const double fast = 3e-4 * std::sin(0.3 * t + phases[1]) * std::sin(2.0 * element::kPi * 5.0 * t + phases[2]) +
                        2e-4 * std::sin(0.4 * t + phases[2]) * std::sin(2.0 * element::kPi * 12.0 * t + phases[1]);
    log.stamp.push_back(static_cast<std::int64_t>(i) * 2000000);
    log.displacement.push_back(slow + fast);
  }
  const std::vector<double> rest = missing(log.displacement);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    log.force.push_back(kStiffness * log.displacement[i] + rest[i] + normal(generator));
  }
  return log::makeRecord(log);
}

struct Errors {
  double before = 0.0;  // gap before and after the fit
  double after = 0.0;
};

Errors errorsOf(const std::vector<fit::UnseenBlock>& unseen) {
  Errors errors;
  for (const fit::UnseenBlock& block : unseen) {
    errors.before += block.weight * block.before;
    errors.after += block.weight * block.after;
  }
  return {std::sqrt(errors.before), std::sqrt(errors.after)};
}

const std::vector<element::ElementDescription> kModel = {{"spring", {{"stiffness", {kStiffness}}}}};

fit::SurrogateFit fitTo(const std::vector<gap::PreparedRecord>& records) {
  return fit::fitSurrogate(records, gap::simulate(kModel, records, gap::asRecorded), 1);
}

std::vector<gap::PreparedRecord> threeLogs(const Missing& missing) {
  return {record(1, missing), record(2, missing), record(3, missing)};
}

/// Expects that 60 % of the gap above the noise floor closes, both on left-out logs and, with the written element, on a
/// further log.
void expectClosed(const Missing& missing) {
  const std::vector<gap::PreparedRecord> records = threeLogs(missing);
  const fit::SurrogateFit fit = fitTo(records);
  ASSERT_TRUE(fit.predicts);
  const Errors errors = errorsOf(fit.unseen);
  const double floor = kNoise / records[0].force_deviation;
  EXPECT_LT(errors.after - floor, 0.4 * (errors.before - floor)) << errors.before << " to " << errors.after;
  const std::vector<gap::PreparedRecord> other = {record(4, missing)};
  std::vector<element::ElementDescription> with = kModel;
  const double before = gap::gapOfParts(gap::partErrors(other, gap::simulate(with, other, gap::asRecorded)));
  with.push_back(fit.element);
  const double after = gap::gapOfParts(gap::partErrors(other, gap::simulate(with, other, gap::asRecorded)));
  EXPECT_LT(after - floor, 0.4 * (before - floor)) << before << " to " << after;
}

std::vector<double> each(const std::vector<double>& z, const std::function<double(double)>& force) {
  std::vector<double> result(z.size());
  std::transform(z.begin(), z.end(), result.begin(), force);
  return result;
}

TEST(Surrogate, ClosesACharacteristicWithTeeth) {
  expectClosed([](const std::vector<double>& z) {
    return each(z, [](double x) { return 150.0 * std::sin(2.0 * element::kPi * x / 4e-4); });
  });
}

TEST(Surrogate, ClosesHysteresisThatGrowsWithAmplitude) {
  expectClosed([](const std::vector<double>& z) {
    std::vector<double> force;
    double slider = 0.0;
    double last = z[0];
    for (const double x : z) {
      slider = std::clamp(slider + x - last, -2e-4, 2e-4);
      last = x;
      force.push_back(1.5e6 * slider * (0.3 + std::abs(x) / 1e-3));
    }
    return force;
  });
}

// An oscillator of 7 Hz with a damping ratio of 0.08 is attached to the component.
TEST(Surrogate, ClosesAResonance) {
  expectClosed([](const std::vector<double>& z) {
    constexpr double kOmega = 2.0 * element::kPi * 7.0;
    constexpr int kParts = 10;
    double position = z[0];
    double velocity = 0.0;
    std::vector<double> force;
    for (std::size_t i = 0; i < z.size(); ++i) {
      for (int part = 1; part <= kParts && i > 0; ++part) {
        const double driven = z[i - 1] + (z[i] - z[i - 1]) * part / kParts;
        velocity += kStep / kParts * (kOmega * kOmega * (driven - position) - 2.0 * 0.08 * kOmega * velocity);
        position += kStep / kParts * velocity;
      }
      force.push_back(2e5 * (z[i] - position));
    }
    return force;
  });
}

// The length of the logs does not change the prior of the rig: the same share of an offset of 200 N is attributed to
// the rig, even beyond 40,000 samples, where some samples are omitted.
TEST(Surrogate, LeavesTheRigItsPriorAtEveryLength) {
  const auto leftBefore = [](std::size_t logs) {
    std::vector<gap::PreparedRecord> records;
    for (std::size_t r = 0; r < logs; ++r) {
      gap::PreparedRecord& one =
          records.emplace_back(record(1, [](const auto& z) { return std::vector<double>(z.size(), 200.0); }));
      const double deviation = 20.0;  // standard deviation of the offset [N]
      const double error = 0.1 * one.force_deviation * std::sqrt(one.counted());
      one.rig.columns = numerics::whiteningColumns(Eigen::VectorXd::Constant(one.size(), deviation / error));
    }
    return errorsOf(fitTo(records).unseen).before;
  };
  EXPECT_NEAR(leftBefore(4), leftBefore(1), 1e-3 * leftBefore(1));
}

// A force that does not depend on the motion is not fitted: the error on left-out logs changes by at most 1 %.
TEST(Surrogate, LeavesHumAlone) {
  unsigned log = 0;
  const fit::SurrogateFit fit = fitTo(threeLogs([&](const std::vector<double>& z) {
    std::vector<double> force(z.size());
    const double phase = 1.7 * ++log;
    for (std::size_t i = 0; i < z.size(); ++i) {
      force[i] = 150.0 * std::sin(2.0 * element::kPi * 4.3 * kStep * static_cast<double>(i) + phase);
    }
    return force;
  }));
  const Errors errors = errorsOf(fit.unseen);
  EXPECT_GT(errors.after, 0.97 * errors.before);
  EXPECT_LT(errors.after, 1.01 * errors.before);
}

TEST(Surrogate, IsFittedToASingleLogByBlocks) {
  const fit::SurrogateFit fit = fitTo({record(5, [](const std::vector<double>& z) {
    return each(z, [](double x) { return 150.0 * std::sin(2.0 * element::kPi * x / 1e-3); });
  })});
  const Errors errors = errorsOf(fit.unseen);
  EXPECT_LT(errors.after, 0.5 * errors.before);
}

// Doubling stroke and force and halving the time must only change the units of the result.
TEST(Surrogate, ScalesWithTheLog) {
  const Missing teeth = [](const std::vector<double>& z) {
    return each(z, [](double x) { return 150.0 * std::sin(2.0 * element::kPi * x / 1e-3); });
  };
  const std::vector<gap::PreparedRecord> records = threeLogs(teeth);
  std::vector<gap::PreparedRecord> scaled = records;
  for (log::Record& of_log : scaled) {
    of_log.dt *= 0.5;
    of_log.displacement *= 2.0;
    of_log.raw_displacement *= 2.0;
    of_log.displacement_noise *= 2.0;
    of_log.force *= 2.0;
    of_log.force_deviation *= 2.0;
    of_log.highest_frequency *= 2.0;
    of_log.lowest_frequency *= 2.0;
    of_log.mean_frequency *= 2.0;
  }
  const Errors expected = errorsOf(fitTo(records).unseen);
  const Errors found = errorsOf(fitTo(scaled).unseen);
  EXPECT_NEAR(found.before, expected.before, 1e-9);
  EXPECT_NEAR(found.after, expected.after, 1e-6);  // rounding, with a condition number of 1e7
}

}  // namespace
}  // namespace rubber_suspension
