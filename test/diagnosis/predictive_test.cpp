// Intervals of the share of the gap that a law closes on further logs: their coverage, and what narrows them.
#include "diagnosis/results/predictive.h"

#include "diagnosis/judge/score.h"
#include "judge/made_evidence.h"
#include "rubber_suspension/gap/gap.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

using diagnosis::judge::Evidence;
using diagnosis::results::Closing;

constexpr double kGap = 0.2;       // before augmentation
constexpr double kRemoved = 0.03;  // square of the force that the law adds, relative to the measured force
constexpr Closing kFirst{Evidence::kFirstSingle, 1.0, true};

double width(const std::array<double, 2>& interval) { return interval[1] - interval[0]; }

// Draws logs of one rig. Its law has the residual that the judgement expects, times a random factor of the rig.
class Rig {
 public:
  explicit Rig(unsigned seed) : generator_(seed) {
    const diagnosis::judge::JudgeNumbers& numbers = diagnosis::judge::fittedNumbers();
    expected_ = std::pow(numbers.floor_known * kFloor, 2) + std::pow(numbers.accepted, 2) +
                std::pow(numbers.form_error, 2) * kRemoved;
    variance_ = expected_ * numbers.tails / std::chi_squared_distribution<double>(numbers.tails)(generator_);
  }

  std::vector<double> left(std::size_t logs) {
    std::vector<double> squares(logs);
    for (double& square : squares) {
      square = kFloor * kFloor + std::min(kGap * kGap - kFloor * kFloor, variance_ * std::pow(normal_(generator_), 2));
    }
    return squares;
  }

 private:
  std::mt19937 generator_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  double expected_ = 0.0;
  double variance_ = 0.0;
};

Evidence evidenceOf(const std::vector<double>& left) {
  Evidence evidence = unexplained(left.size(), 1, kGap);
  evidence.hypotheses[Evidence::kFirstSingle] = fitted({0}, left, {std::vector<double>(left.size(), kRemoved)});
  for (diagnosis::judge::LogEvidence& log : evidence.logs) {
    log.floor_uncertainty = 0.0;
  }
  return evidence;
}

double closedOf(const std::vector<double>& left) {
  double sum = 0.0;
  for (const double square : left) {
    sum += square / static_cast<double>(left.size());
  }
  return gap::closedFraction(kGap, std::sqrt(sum), kFloor);
}

// The rigs follow the model of the judgement, so 95 % of 200 intervals contain the share closed on further logs. The
// tolerance is four standard deviations.
TEST(ClosedOnFurtherLogs, HoldsWhatIsClosedThere) {
  for (const std::size_t logs : {3U, 6U}) {
    int held = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
      Rig rig(seed);
      const auto interval = closedOnFurtherLogs(scoreTable(evidenceOf(rig.left(logs))), kFirst, 400, seed);
      const double closed = closedOf(rig.left(logs));
      held += interval[0] <= closed && closed <= interval[1] ? 1 : 0;
    }
    EXPECT_NEAR(held, 190, 12) << logs << " logs";
  }
}

TEST(ClosedOnFurtherLogs, IsNarrowWhereManyLogsAgree) {
  const double left = kFloor * kFloor + 1e-5;
  const auto few = closedOnFurtherLogs(scoreTable(evidenceOf(std::vector<double>(2, left))), kFirst, 1000, 1);
  const auto many = closedOnFurtherLogs(scoreTable(evidenceOf(std::vector<double>(12, left))), kFirst, 1000, 1);
  EXPECT_LT(width(many), 0.7 * width(few));
  EXPECT_GT(few[0], 0.0);
  EXPECT_GT(many[0], 0.9);
}

// If other effects act besides the law, the prior of its form error does not apply.
TEST(ClosedOnFurtherLogs, IsWiderBesideARest) {
  const Evidence evidence = evidenceOf(std::vector<double>(3, std::pow(0.08, 2)));
  Closing beside = kFirst;
  beside.alone = 0.0;
  EXPECT_GT(width(closedOnFurtherLogs(scoreTable(evidence), beside, 1000, 1)),
            width(closedOnFurtherLogs(scoreTable(evidence), kFirst, 1000, 1)));
}

// A law that closes some of the gap never opens it on further logs. A law without such evidence may do so.
TEST(ClosedOnFurtherLogs, IsBelowZeroForLawsThatAreNotAtWorkAlone) {
  const Evidence evidence = evidenceOf(std::vector<double>(2, std::pow(0.19, 2)));
  Closing other = kFirst;
  other.at_work = false;
  EXPECT_GE(closedOnFurtherLogs(scoreTable(evidence), kFirst, 1000, 1)[0], 0.0);
  EXPECT_LT(closedOnFurtherLogs(scoreTable(evidence), other, 1000, 1)[0], 0.0);
}

TEST(ClosedOnFurtherLogs, IsTheSameWithTheSameSeed) {
  const Evidence evidence = evidenceOf(std::vector<double>(3, std::pow(0.02, 2)));
  EXPECT_EQ(closedOnFurtherLogs(scoreTable(evidence), kFirst, 100, 7),
            closedOnFurtherLogs(scoreTable(evidence), kFirst, 100, 7));
}

}  // namespace
}  // namespace rubber_suspension::test
