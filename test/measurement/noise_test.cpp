// Noise models: coloured noise is detected, whitening yields white noise, and the noise floor equals the true noise.
#include "measurement/examine.h"
#include "measurement/functions_of_motion.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/measurement/noise_floor.h"
#include "rubber_suspension/measurement/noise_model.h"
#include "support/test.h"

namespace rubber_suspension::measurement {
namespace {

constexpr Eigen::Index kCount = 10000;

TEST(NoiseModel, TellsColour) {
  int false_findings = 0;
  int found = 0;
  int covered = 0;
  constexpr int kDraws = 40;
  for (unsigned seed = 1; seed <= kDraws; ++seed) {
    Perturbation p;
    const Mask mask = Mask::Constant(kCount, true);
    false_findings += colouredNoiseFinding("log", estimateNoise(unitNoise(kCount, p, seed), mask)) ? 1 : 0;
    p.pink = true;
    const auto finding = colouredNoiseFinding("log", estimateNoise(unitNoise(kCount, p, seed), mask));
    found += finding ? 1 : 0;
    covered += finding && covers(*finding, 1.0) ? 1 : 0;
  }
  std::cout << "coloured noise: found " << found << " of " << kDraws << ", covered " << covered << ", false "
            << false_findings << "\n";
  EXPECT_LE(false_findings, 1);
  EXPECT_EQ(found, kDraws);
  EXPECT_GE(covered, 34);  // binomial: in only 1 of 100 runs, fewer of 40 intervals of 95 % contain the truth
}

// Whitened noise has a standard deviation of 1 and no correlation, with or without missing samples.
TEST(Whitener, Whitens) {
  for (const int kind : {0, 1, 2}) {
    Perturbation p;
    p.pink = kind == 1;
    p.anti_alias = kind == 2 ? 0.1 : 0.0;
    const Eigen::VectorXd noise = 3.0 * unitNoise(kCount, p, 5);
    Mask mask = Mask::Constant(kCount, true);
    mask.segment(3000, 40).setConstant(false);
    mask[7000] = false;
    const Whitener whitener(estimateNoise(noise, mask), mask);
    const Eigen::VectorXd white = whitener(noise).col(0);
    EXPECT_EQ(white[3010], 0.0);
    // The estimates have standard deviations of 0.007 and 0.01. Low-pass filtered noise needs the wider limits.
    EXPECT_NEAR(std::sqrt(white.squaredNorm() / static_cast<double>(mask.count())), 1.0, 0.05) << kind;
    EXPECT_NEAR(white.head(kCount - 1).dot(white.tail(kCount - 1)) / white.squaredNorm(), 0.0, 0.06) << kind;
  }
}

// Computes the likelihood from whitened unit vectors: a factor of the density is the determinant of their matrix.
double logLikelihood(const NoiseModel& model, const Mask& mask, const Eigen::VectorXd& noise) {
  const Whitener whiten(model, mask);
  const Eigen::MatrixXd matrix = whiten(Eigen::MatrixXd::Identity(noise.size(), noise.size()));
  return -0.5 * whiten(noise).squaredNorm() + matrix.diagonal().array().log().sum() -
         0.5 * std::log(2.0 * element::kPi) * static_cast<double>(noise.size());
}

// The estimated model has a higher likelihood than white noise with the same standard deviation.
TEST(Whitener, PrefersTheColourThatIsThere) {
  constexpr Eigen::Index kFew = 1000;
  Perturbation p;
  p.pink = true;
  const Eigen::VectorXd noise = unitNoise(kFew, p, 3);
  const Mask mask = Mask::Constant(kFew, true);
  NoiseModel white;
  white.white = 1.0;
  white.samples = kFew;
  EXPECT_GT(logLikelihood(estimateNoise(noise, mask), mask, noise), logLikelihood(white, mask, noise) + 10.0);
  // The likelihood of white noise has a closed form.
  EXPECT_NEAR(logLikelihood(white, mask, noise),
              -0.5 * noise.squaredNorm() - 0.5 * std::log(2.0 * element::kPi) * static_cast<double>(kFew), 1e-6 * kFew);
}

// The estimated noise floor is within a factor of 1.3 of the noise in 90 % of the rigs, for each kind of noise.
TEST(NoiseFloor, IsThatOfTheNoise) {
  Perturbation pink;
  pink.pink = true;
  Perturbation filtered;
  filtered.anti_alias = 0.1;
  for (const auto& [label, p] : {std::make_pair("white", Perturbation()), {"1/f", pink}, {"filtered", filtered}}) {
    int within = 0;
    const std::vector<VirtualRig> rigs = allRigs(4);
    for (const VirtualRig& rig : rigs) {
      const VirtualLog log = runRig(rig, p);
      const Examined examined = examine(log, elementsOf(rig));
      const double floor = noiseFloor(examined.record, examined.fit.residual, examined.faults.usable());
      const double ratio = floor / log.noise;
      within += ratio > 1.0 / 1.3 && ratio < 1.3 ? 1 : 0;
      if (ratio <= 1.0 / 1.3 || ratio >= 1.3) {
        std::cout << "  " << label << ", law " << static_cast<int>(rig.law) << ", motion "
                  << static_cast<int>(rig.motion) << ", seed " << rig.seed << ": " << ratio << "\n";
      }
    }
    std::cout << "floor, " << label << ": " << within << " of " << rigs.size() << " within 1.3\n";
    EXPECT_GE(within, 0.9 * static_cast<double>(rigs.size())) << label;
  }
}

// A residual that follows the motion is a model error, not noise. Here a third of the Maxwell element is missing, a
// force of ten times the white noise. In contrast, 1/f noise is found in most rigs.
TEST(EvidenceOfNoise, IsThatOfAPowerThatDoesNotFollowTheMotion) {
  const std::vector<VirtualRig> rigs = allRigs(2);
  const auto coloured = [&](const Perturbation& p, double of_maxwell) {
    int found = 0;
    for (const VirtualRig& rig : rigs) {
      Elements elements = elementsOf(rig);
      elements[1].values["stiffness"][0] *= of_maxwell;
      const Examined examined = examine(runRig(rig, p), elements);
      const auto evidence = evidenceOfNoise(examined.record, examined.fit.residual, examined.faults.usable());
      found += evidence.value_or(0.0) > 5.0 ? 1 : 0;
    }
    return found;
  };
  Perturbation pink;
  pink.pink = true;
  const int of_error = coloured({}, 0.67);
  const int of_noise = coloured(pink, 1.0);
  std::cout << "coloured noise in " << rigs.size() << " rigs: found " << of_noise << ", false " << of_error << "\n";
  EXPECT_LE(of_error, 1);
  EXPECT_GE(of_noise, 20);
}

// The forces of a stop and a cubic spring are removed. The noise remains, except for the part that the functions fit.
TEST(FunctionsOfMotion, AreNoNoise) {
  for (const Motion motion : {Motion::sines, Motion::sweep, Motion::track}) {
    VirtualRig rig;
    rig.motion = motion;
    const log::Record record = log::makeRecord(runRig(rig).log);
    const Mask mask = Mask::Constant(record.size(), true);
    const Eigen::VectorXd noise = unitNoise(record.size(), {}, 7);
    const Eigen::ArrayXd z = record.displacement.array() / record.displacement.cwiseAbs().maxCoeff();
    const Eigen::VectorXd missing = 20.0 * (z.cube() + 3.0 * (z - 0.6).max(0.0)).matrix();
    const Eigen::VectorXd rest = withoutFunctionsOfMotion(record, noise + missing, mask);
    const double left = std::sqrt(rest.squaredNorm() / static_cast<double>(rest.size()));
    // Linear interpolation with a step h = 2/11 misses the knee by up to 60 h/8 = 1.4 in one of eleven intervals, and
    // the cubic by 120 h^2/12 = 0.3 at its ends. Both add 3 % to the noise.
    EXPECT_LT(left, 1.05);
    // The fit of 39 functions to 10 000 samples removes little of the noise.
    EXPECT_GT(std::sqrt(withoutFunctionsOfMotion(record, noise, mask).squaredNorm() / static_cast<double>(rest.size())),
              0.97);
  }
}

TEST(FunctionsOfMotion, OfAShortLogAreNone) {
  VirtualRig rig;
  rig.duration = 0.5;
  const log::Record record = log::makeRecord(runRig(rig).log);
  const Eigen::VectorXd noise = unitNoise(record.size(), {}, 7);
  EXPECT_EQ(withoutFunctionsOfMotion(record, noise, Mask::Constant(record.size(), true)), noise);
}

TEST(NoiseFloor, IsNeverZeroNorAboveTheModel) {
  VirtualRig rig;
  rig.noise = 0.0;
  const log::Record record = log::makeRecord(runRig(rig).log);
  const Mask mask = Mask::Constant(record.size(), true);
  EXPECT_GT(noiseFloor(record, Eigen::VectorXd::Zero(record.size()), mask), 0.0);
  const Eigen::VectorXd residual = 5.0 * unitNoise(record.size(), {}, 1);
  const double left = std::sqrt(residual.squaredNorm() / static_cast<double>(record.size()));
  EXPECT_LE(noiseFloor(record, residual, mask), left * (1.0 + 1e-12));  // the sums have another order
}

}  // namespace
}  // namespace rubber_suspension::measurement
