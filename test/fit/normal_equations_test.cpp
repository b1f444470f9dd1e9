// Normal equations of the blocks of logs: weights, and blocks without valid samples.
#include "fit/normal_equations.h"

#include "numerics/gram.h"
#include "numerics/least_squares.h"
#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension::fit {
namespace {

// Returns forty cycles at 1 Hz, in which the samples from `first` to `last` have no weight.
gap::PreparedRecord record(Eigen::Index first, Eigen::Index last) {
  constexpr Eigen::Index kSamples = 4000;
  gap::PreparedRecord result;
  result.dt = 0.01;
  result.lowest_frequency = result.mean_frequency = 1.0;
  const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(kSamples, 0.0, 39.99);
  result.displacement = result.raw_displacement = (2.0 * element::kPi * time).sin();
  result.force = 3.0 * result.displacement.array() + 0.1 * (40.0 * time).sin();
  result.force_deviation = std::sqrt(result.force.squaredNorm() / kSamples);
  if (last > first) {
    result.counts = Eigen::VectorXd::Ones(kSamples);
    result.counts.segment(first, last - first).setZero();
  }
  return result;
}

BlockGrams equations(const std::vector<gap::PreparedRecord>& records) {
  std::vector<double> weights;
  gap::Forces base;
  gap::Forces column;
  for (const gap::PreparedRecord& one : records) {
    weights.push_back(1.0 / (one.force_deviation * std::sqrt(one.counted() * static_cast<double>(records.size()))));
    base.emplace_back(Eigen::VectorXd::Zero(one.size()));
    column.push_back(one.displacement);
  }
  return LogBlocks(records, weights)
      .normalEquations(base, {columnOf(column)}, {PerLogNuisances{}}, Kept::blocks, 1)
      .front();
}

double heldOut(const BlockGrams& blocks) {
  const Eigen::VectorXd bound = Eigen::VectorXd::Constant(blocks.unknowns(), 1e9);
  const std::vector<double> errors =
      crossValidate(blocks, [&](const Eigen::MatrixXd& gram) { return solve(gram, {-bound, bound}); });
  return std::sqrt(std::inner_product(errors.begin(), errors.end(), blocks.weight.begin(), 0.0));
}

// If a sensor fails for ten cycles, some blocks have no valid samples and are omitted.
TEST(NormalEquations, LeaveOutBlocksWithoutSamplesThatCount) {
  const BlockGrams whole = equations({record(0, 0), record(0, 0)});
  for (const Eigen::Index first : {Eigen::Index{0}, Eigen::Index{1200}, Eigen::Index{3000}}) {
    const BlockGrams blocks = equations({record(0, 0), record(first, first + 1000)});
    EXPECT_LT(blocks.gram.size(), whole.gram.size());
    EXPECT_NEAR(std::accumulate(blocks.weight.begin(), blocks.weight.end(), 0.0), 1.0, 1e-12);
    for (const double weight : blocks.weight) {
      EXPECT_GT(weight, 0.0);
    }
    // The force is the same, so the residual is the same up to the boundaries of the cycles.
    EXPECT_NEAR(heldOut(blocks), heldOut(whole), 0.02 * heldOut(whole));
  }
}

double heldOutBesideTrends(const gap::PreparedRecord& one) {
  const double weight = 1.0 / (one.force_deviation * std::sqrt(one.counted()));
  const std::vector<gap::PreparedRecord> records = {one};
  return heldOut(LogBlocks(records, {weight})
                     .normalEquations({Eigen::VectorXd::Zero(one.size())}, {columnOf({one.displacement})},
                                      {PerLogNuisances{true, true}}, Kept::blocks, 1)
                     .front());
}

// A trend with the covariance of a random walk predicts held-out blocks of such a force better than a free trend.
TEST(NormalEquations, HaveTrendsOfARandomWalk) {
  gap::PreparedRecord one = record(0, 0);
  std::mt19937 generator(1);
  std::normal_distribution<double> step(0.0, 0.005);
  double walk = 0.0;
  for (Eigen::Index i = 0; i < one.size(); ++i) {
    walk += step(generator);
    one.force[i] += walk;
  }
  const double free = heldOutBesideTrends(one);
  one.rig.one_deviation = 0.005;
  EXPECT_LT(heldOutBesideTrends(one), 0.9 * free);
  one.lowest_frequency = 0.05;  // an octave above the second half cosine, but not above the third
  EXPECT_LT(PerLogNuisances{true}.costs(one)[2], 1.0);
  EXPECT_GT(PerLogNuisances{true}.costs(one)[3], 1e3);
}

// Adds the errors of a rig: an offset with a prior, and a slow wave without a prior.
void addRig(gap::PreparedRecord& one) {
  Eigen::MatrixXd columns(one.size(), 2);
  columns.col(0).setConstant(0.02);
  columns.col(1) = 10.0 * Eigen::ArrayXd::LinSpaced(one.size(), 0.0, 3.0).sin();
  if (one.counts.size() > 0) {
    columns.array().colwise() *= one.counts.array();
  }
  one.rig.columns = numerics::whiteningColumns(columns);
}

// Precomputing the products of known columns gives the same blocks. They agree with PreparedRecord::withoutRig().
TEST(NormalEquations, AreTheSameWithKnownColumns) {
  std::vector<gap::PreparedRecord> records = {record(0, 0), record(300, 400)};
  std::vector<double> weights;
  gap::Forces base;
  gap::Forces displacement;
  gap::Forces cubic;
  for (gap::PreparedRecord& one : records) {
    addRig(one);
    weights.push_back(0.7 / one.force_deviation);
    base.emplace_back(0.1 * one.force);
    displacement.push_back(one.displacement);
    cubic.emplace_back(one.displacement.array().cube() + 0.3);
  }
  const std::vector<ForceColumn> columns = {columnOf(displacement), nullptr, columnOf(cubic)};
  const BlockGrams plain =
      LogBlocks(records, weights).normalEquations(base, columns, {PerLogNuisances{}}, Kept::blocks, 1).front();
  const BlockGrams faster = LogBlocks(records, weights, {columns[2]}, 2)
                                .normalEquations(base, columns, {PerLogNuisances{}}, Kept::blocks, 1)
                                .front();
  ASSERT_EQ(plain.gram.size(), faster.gram.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(plain.gram[0].rows(), plain.gram[0].rows());
  for (std::size_t b = 0; b < plain.gram.size(); ++b) {
    EXPECT_LT((plain.gram[b] - faster.gram[b]).cwiseAbs().maxCoeff(), 1e-10) << b;
    sum += plain.gram[b];
  }
  double expected = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    expected += std::pow(weights[r], 2) *
                records[r].withoutRig(displacement[r]).dot(records[r].withoutRig(records[r].force - base[r]));
  }
  constexpr double kRounding = std::numeric_limits<float>::epsilon();  // columns have single precision
  EXPECT_NEAR(sum(0, sum.cols() - 1), expected, kRounding * std::abs(expected));
}

TEST(WhiteningColumns, MakeErrorsAndUnknownsWhite) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Random(30, 4);
  c.col(2) = c.col(0) - 2.0 * c.col(1);  // a linear combination of the other two columns
  c.col(3) *= 1e3;                       // nearly without a prior
  const Eigen::MatrixXd n = numerics::whiteningColumns(c);
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(30, 30);
  const Eigen::MatrixXd root = identity - n * n.transpose();
  EXPECT_LT((root * (identity + c * c.transpose()) * root - identity).cwiseAbs().maxCoeff(), 1e-6);
  const Eigen::MatrixXd again = numerics::columnsOfWhitening(n);
  EXPECT_LT((again * again.transpose() - c * c.transpose()).cwiseAbs().maxCoeff(), 1e-3);  // relative to values of 1e6
}

// Products of columns are correct up to rounding for any number of rows and columns and on any processor.
TEST(Gram, IsTheProductOfTheColumns) {
  for (const auto& [rows, columns] : {std::pair(1, 1), {7, 2}, {255, 3}, {256, 4}, {300, 7}, {1031, 40}}) {
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(rows, columns);
    const Eigen::MatrixXd gram = numerics::gramOf(matrix);
    const Eigen::MatrixXd expected = matrix.transpose() * matrix;
    EXPECT_LT((gram - expected).cwiseAbs().maxCoeff(), 1e-12 * rows) << rows << " x " << columns;
    EXPECT_EQ(gram, Eigen::MatrixXd(gram.transpose()));
    const Eigen::MatrixXd other = Eigen::MatrixXd::Random(rows, columns + 5);
    const Eigen::MatrixXd mixed = matrix.transpose() * other;
    EXPECT_LT((numerics::productOf(matrix, other) - mixed).cwiseAbs().maxCoeff(), 1e-12 * rows);
  }
}

}  // namespace
}  // namespace rubber_suspension::fit
