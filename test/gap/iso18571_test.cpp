// The rating of ISO/TS 18571 agrees with values computed by hand, and by a simple numpy program that tries every shift
// and fills every cell of the warping matrix.
#include "rubber_suspension/gap/iso18571.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

using gap::Iso18571;

Eigen::VectorXd signal(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

template <class Law>
Eigen::VectorXd signal(Eigen::Index size, Law law) {
  return Eigen::VectorXd::NullaryExpr(size, [&](Eigen::Index i) { return law(static_cast<double>(i)); });
}

void expectRating(const Iso18571& rating, double corridor, double phase, double magnitude, double slope,
                  double tolerance) {
  EXPECT_NEAR(rating.corridor, corridor, tolerance);
  EXPECT_NEAR(rating.phase, phase, tolerance);
  EXPECT_NEAR(rating.magnitude, magnitude, tolerance);
  EXPECT_NEAR(rating.slope, slope, tolerance);
  EXPECT_NEAR(rating.total, 0.4 * corridor + 0.2 * (phase + magnitude + slope), tolerance);
}

// One of five samples is 3 instead of 4: ((2 - 1)/1.8)^2 for the corridor, 1/8 for the magnitude. The differences are
// 2, 2, 0, -2, -2 and 2, 1.5, 0, -1.5, -2, their means over 1, 3, 5, 3, 1: 2, 4/3, 0, -4/3, -2 and 2, 7/6, 0, -7/6, -2.
TEST(Iso18571, OfFiveSamplesByHand) {
  const Iso18571 rating = gap::rateIso18571(signal({0, 2, 4, 2, 0}), signal({0, 2, 3, 2, 0}));
  expectRating(rating, (4.0 + std::pow(1.0 / 1.8, 2)) / 5.0, 1.0, 1.0 - 0.125 / 0.5,
               1.0 - (1.0 / 3.0) / (20.0 / 3.0) / 2.0, 1e-12);
}

// The delay is one sample, and two samples are allowed. After the shift the signals are equal.
TEST(Iso18571, OfADelayByHand) {
  const Iso18571 rating =
      gap::rateIso18571(signal({0, 1, 4, 3, 1, 0, -1, 0, 0, 0}), signal({0, 0, 1, 4, 3, 1, 0, -1, 0, 0}));
  const double one_off = std::pow(1.0 / 1.8, 2);  // five samples are off by 1, one at the edge by 2, one by 3
  expectRating(rating, (3.0 + 5.0 * one_off) / 10.0, 0.5, 1.0, 1.0, 1e-12);
}

TEST(Iso18571, OfPulsesAsNumpyHasIt) {
  const auto pulse = [](double k, double place, double width) { return std::exp(-std::pow((k - place) / width, 2)); };
  const Iso18571 rating = gap::rateIso18571(
      signal(200, [&](double k) { return pulse(k, 80, 20) + 0.3 * pulse(k, 130, 10); }),
      signal(200, [&](double k) { return 1.1 * pulse(k, 86, 22) + 0.25 * pulse(k, 133, 12) + 0.02; }));
  expectRating(rating, 0.843932345393404, 0.85, 0.8229883094474515, 0.9116849797575, 1e-12);
  EXPECT_FALSE(rating.repeats);
  EXPECT_EQ(gap::iso18571Grade(rating.total), "good");
}

TEST(Iso18571, OfADecayingSineAsNumpyHasIt) {
  const Iso18571 rating =
      gap::rateIso18571(signal(500, [](double k) { return std::sin(0.1 * k) * std::exp(-k / 150.0); }),
                        signal(500, [](double k) { return std::sin(0.1 * k + 0.3) * std::exp(-k / 140.0); }));
  expectRating(rating, 0.8890426004661562, 0.97, 0.947461305488542, 0.9769478426956874, 1e-12);
}

TEST(Iso18571, OfEqualAndOfHopelessSignals) {
  const Eigen::VectorXd test = signal(300, [](double k) { return std::exp(-std::pow((k - 100) / 30, 2)); });
  expectRating(gap::rateIso18571(test, test), 1.0, 1.0, 1.0, 1.0, 0.0);
  EXPECT_EQ(gap::rateIso18571(test, -3.0 * test).magnitude + gap::rateIso18571(test, -3.0 * test).slope, 0.0);
  Eigen::VectorXd broken = test;
  broken[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(gap::rateIso18571(test, broken).total, 0.0);
  EXPECT_THROW(gap::rateIso18571(broken, test), std::invalid_argument);
  EXPECT_THROW(gap::rateIso18571(Eigen::VectorXd::Ones(9), signal(9, [](double k) { return k; })),
               std::invalid_argument);
  EXPECT_THROW(gap::rateIso18571(test, test.head(299)), std::invalid_argument);
  EXPECT_EQ(gap::iso18571Grade(0.95) + gap::iso18571Grade(0.6) + gap::iso18571Grade(0.5), "excellentfairpoor");
}

// The rating does not depend on the unit, even if one value is 1e200, or if the squares of the values overflow or
// vanish.
TEST(Iso18571, OfNumbersWhoseSquaresOverflow) {
  const Eigen::VectorXd test = signal(50, [](double k) { return std::sin(0.1 * k) * std::exp(-k / 30.0); });
  Eigen::VectorXd burst = test;
  burst[20] = 1e200;
  const Iso18571 rating = gap::rateIso18571(test, burst);
  EXPECT_GT(rating.corridor, 0.9);
  EXPECT_EQ(rating.magnitude, 0.0);
  const Eigen::VectorXd model = 0.9 * test;
  for (const double unit : {std::ldexp(1.0, 600), std::ldexp(1.0, -600)}) {
    EXPECT_EQ(gap::rateIso18571(unit * test, unit * model).total, gap::rateIso18571(test, model).total);
  }
}

// A sine, and sines of several frequencies one after the other, repeat themselves. A sweep and a pulse do not.
TEST(Iso18571, SeesWhatRepeatsItself) {
  const auto repeats = [](const Eigen::VectorXd& test) { return gap::rateIso18571(test, test).repeats; };
  EXPECT_TRUE(repeats(signal(1000, [](double k) { return std::sin(0.05 * k); })));
  EXPECT_TRUE(repeats(signal(6000, [](double k) { return std::sin((k < 2000 ? 0.05 : k < 4000 ? 0.1 : 0.2) * k); })));
  EXPECT_FALSE(repeats(signal(1000, [](double k) { return std::sin(1e-3 * k * k); })));
  EXPECT_FALSE(repeats(signal(1000, [](double k) { return std::exp(-std::pow((k - 400) / 50, 2)); })));
}

// A log of minutes is rated in blocks. The error is uniform, so the magnitude is nearly that of the whole log.
TEST(Iso18571, OfALongLog) {
  const auto law = [](double k) { return std::sin(1e-2 * k) + 0.7 * std::sin(3.1e-3 * k) + std::sin(7.7e-4 * k); };
  const auto model = [&](double k) { return 0.9 * law(k) + 0.05 * std::sin(0.11 * k); };
  const double whole = gap::rateIso18571(signal(9000, law), signal(9000, model)).magnitude;
  const Iso18571 in_blocks = gap::rateIso18571(signal(9000, law), signal(9000, model), 2000);
  EXPECT_EQ(in_blocks.blocks, 5U);
  EXPECT_NEAR(in_blocks.magnitude, whole, 0.02);
  const Iso18571 long_log = gap::rateIso18571(signal(360000, law), signal(360000, model));
  EXPECT_EQ(long_log.blocks, 180U);
  EXPECT_NEAR(long_log.magnitude, whole, 0.05);
}

}  // namespace
}  // namespace rubber_suspension
