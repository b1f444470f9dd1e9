// The report lists what was removed from a log, with kind and size. The squares of these parts add up.
#include "diagnosis/results/taken_out.h"

#include "diagnosis/words/text.h"
#include "gap/simulate.h"
#include "numerics/least_squares.h"
#include "rig.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "support/test.h"

namespace rubber_suspension::diagnosis {
namespace {

// Accounts for a log whose force has an effect added, which the least-squares columns `free` may remove again.
class TakenOutTest : public ::testing::Test {
 protected:
  std::vector<TakenOut> accountFor(const RigEffect& effect, const std::vector<RigEffect>& free) {
    log_ = runRig("log", 3, effect, 2.0);
    spike();
    gap::PreparedRecord record = measurement::prepareLog(log_).record;
    Eigen::MatrixXd columns(record.size(), static_cast<Eigen::Index>(free.size()));
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
      for (Eigen::Index i = 0; i < columns.rows(); ++i) {
        columns(i, j) = free[static_cast<std::size_t>(j)](static_cast<double>(i) * record.dt, 0.0, 0.0);
      }
    }
    if (record.counts.size() > 0) {
      columns.array().colwise() *= record.counts.array();
    }
    record.rig.columns = free.empty() ? columns : numerics::orthonormalColumns(columns);
    deviation_ = record.force_deviation;
    const auto elements = rigComponent().allElements();
    const results::LogAccount account =
        results::accountsOf(elements, {record}, {}, prepare::rawChannels({log_}, {}), {}).front();
    left_ = std::sqrt(account.left());
    double left = account.recorded();
    for (const TakenOut& part : account.entries()) {
      left -= std::copysign(part.share * part.share, part.share);
    }
    EXPECT_NEAR(left, account.left(), 1e-12);
    return account.entries();
  }

  void spike() {
    if (spike_ != 0.0) {
      log_.force[1234] += spike_;
    }
  }

  static double shareOf(const std::vector<TakenOut>& entries, const std::string& kind) {
    for (const TakenOut& part : entries) {
      if (part.kind == kind) {
        return part.share;
      }
    }
    return 0.0;
  }

  log::Log log_;
  double spike_ = 0.0;      // [N]
  double deviation_ = 0.0;  // standard deviation of the force [N]
  double left_ = 0.0;
};

double one(double /*time*/, double /*displacement*/, double /*rate*/) { return 1.0; }
double ramp(double seconds, double /*displacement*/, double /*rate*/) { return seconds; }

TEST_F(TakenOutTest, TellsAZero) {
  const auto parts = accountFor([](double, double, double) { return 60.0; }, {one});
  EXPECT_NEAR(shareOf(parts, results::taken_out::kZero), 60.0 / deviation_, 0.02 * 60.0 / deviation_);
  EXPECT_LT(std::abs(shareOf(parts, results::taken_out::kDrift)), 0.002);
  EXPECT_LT(left_, 0.02);
}

// A ramp from -1 to 1 has an RMS of 1/sqrt(3).
TEST_F(TakenOutTest, TellsADrift) {
  const auto parts = accountFor([](double t, double, double) { return 20.0 * (t - 5.0); }, {one, ramp});
  const double end = 20.0 * (5000.0 * (log_.time(1) - log_.time(0)) - 5.0);
  const double begin = -100.0;
  const double slope = 0.5 * (end - begin);
  EXPECT_NEAR(shareOf(parts, results::taken_out::kDrift), slope / std::sqrt(3.0) / deviation_,
              0.05 * slope / deviation_);
  EXPECT_LT(std::abs(shareOf(parts, results::taken_out::kInitialState)), 0.03);
  EXPECT_LT(left_, 0.02);
}

TEST_F(TakenOutTest, TellsWhatIsLeftFromBefore) {
  const RigEffect decay = [](double t, double, double) { return 200.0 * std::exp(-t / 0.5); };
  const auto parts = accountFor(decay, {one, decay});
  EXPECT_GT(shareOf(parts, results::taken_out::kInitialState), 0.01);
  EXPECT_LT(std::abs(shareOf(parts, results::taken_out::kDrift)), 0.01);
  EXPECT_LT(left_, 0.02);
}

// The force is recorded 3 % too large.
TEST_F(TakenOutTest, TellsAGain) {
  log::Log log = runRig("log", 3, nothing, 2.0);
  for (double& force : log.force) {
    force *= 1.03;
  }
  gap::PreparedRecord record = measurement::prepareLog(log).record;
  const auto elements = rigComponent().allElements();
  record.rig.columns = gap::simulate(elements, {record}).front().normalized();
  const auto parts = results::accountsOf(elements, {record}, {}, prepare::rawChannels({log}, {}), {}).front().entries();
  EXPECT_NEAR(shareOf(parts, results::taken_out::kGain), 0.03 / 1.03, 0.002);
}

TEST_F(TakenOutTest, TellsSpikes) {
  spike_ = 4000.0;
  const auto parts = accountFor(nothing, {});
  EXPECT_NEAR(shareOf(parts, results::taken_out::kSpikes), 4000.0 / std::sqrt(5000.0) / deviation_,
              0.05 * 4000.0 / std::sqrt(5000.0) / deviation_);
}

// Forces that were not measured are replaced, which must not count as spikes.
TEST_F(TakenOutTest, LeavesOutWhatWasNotMeasured) {
  log::Log log = runRig("log", 3, nothing, 2.0);
  log.counts.assign(log.size(), 1.0);
  for (std::size_t i = 1000; i < 1200; ++i) {
    log.counts[i] = 0.0;
    log.force[i] = log.force[999];
  }
  const gap::PreparedRecord record = measurement::prepareLog(log).record;
  const auto account =
      results::accountsOf(rigComponent().allElements(), {record}, {}, prepare::rawChannels({log}, {}), {}).front();
  EXPECT_LT(std::abs(shareOf(account.entries(), results::taken_out::kSpikes)), 1e-3);
  EXPECT_NEAR(std::sqrt(account.recorded()), 2.0 / record.force_deviation, 0.2 / record.force_deviation);
}

TEST(DescribeTakenOut, SaysWhatIsMoreThanAHundredth) {
  EXPECT_THAT(words::describeTakenOut({{"a", "zero", 0.032}, {"a", "drift", 0.1}, {"b", "spikes", 0.004}}),
              ElementsAre("a: zero 3.2 %, drift 10 %"));
  EXPECT_THAT(words::describeTakenOut({}), SizeIs(0));
}

}  // namespace
}  // namespace rubber_suspension::diagnosis
