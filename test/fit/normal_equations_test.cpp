// Blocks of the logs: their weights, and what they leave out.
#include "fit/normal_equations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "fit/gram.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {
namespace {

// Forty cycles at 1 Hz, of which samples from `first` to `last` count for nothing.
log::Record record(Eigen::Index first, Eigen::Index last) {
  constexpr Eigen::Index kSamples = 4000;
  log::Record result;
  result.dt = 0.01;
  result.mean_frequency = 1.0;
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

BlockGrams equations(const std::vector<log::Record>& records) {
  std::vector<double> weights;
  std::vector<Eigen::VectorXd> base;
  std::vector<Eigen::VectorXd> column;
  for (const log::Record& one : records) {
    weights.push_back(1.0 / (one.force_deviation * std::sqrt(one.counted() * static_cast<double>(records.size()))));
    base.emplace_back(Eigen::VectorXd::Zero(one.size()));
    column.push_back(one.displacement);
  }
  BlockGrams blocks =
      normalEquations(records, weights, base, {std::make_shared<const std::vector<Eigen::VectorXd>>(column)}, {}, 1);
  blocks.prior = Eigen::MatrixXd::Zero(2, 2);
  blocks.sumUp();
  return blocks;
}

double heldOut(const BlockGrams& blocks) {
  const Eigen::VectorXd bound = Eigen::VectorXd::Constant(1, 1e9);
  const std::vector<double> errors = crossValidate(blocks, {0}, -bound, bound);
  return std::sqrt(std::inner_product(errors.begin(), errors.end(), blocks.weight.begin(), 0.0));
}

// A sensor that gave nothing for ten cycles leaves blocks without a sample that counts: they take no part.
TEST(NormalEquations, LeaveOutBlocksWithoutSamplesThatCount) {
  const BlockGrams whole = equations({record(0, 0), record(0, 0)});
  for (const Eigen::Index first : {Eigen::Index{0}, Eigen::Index{1200}, Eigen::Index{3000}}) {
    const BlockGrams blocks = equations({record(0, 0), record(first, first + 1000)});
    EXPECT_LT(blocks.gram.size(), whole.gram.size());
    EXPECT_NEAR(std::accumulate(blocks.weight.begin(), blocks.weight.end(), 0.0), 1.0, 1e-12);
    for (const double weight : blocks.weight) {
      EXPECT_GT(weight, 0.0);
    }
    // The same force, so the same rest: 0.1 of 3 but for where the cycles of the two are cut.
    EXPECT_NEAR(heldOut(blocks), heldOut(whole), 0.02 * heldOut(whole));
  }
}

// Any number of rows and columns, on any processor, to the last bits of a sum.
TEST(Gram, IsTheProductOfTheColumns) {
  for (const auto& [rows, columns] : {std::pair(1, 1), {7, 2}, {255, 3}, {256, 4}, {300, 7}, {1031, 40}}) {
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(rows, columns);
    const Eigen::MatrixXd gram = gramOf(matrix);
    const Eigen::MatrixXd expected = matrix.transpose() * matrix;
    EXPECT_LT((gram - expected).cwiseAbs().maxCoeff(), 1e-12 * rows) << rows << " x " << columns;
    EXPECT_EQ(gram, Eigen::MatrixXd(gram.transpose()));
  }
}

}  // namespace
}  // namespace rubber_suspension::fit
