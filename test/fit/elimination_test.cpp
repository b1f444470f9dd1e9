// Eliminating the nuisance parameters of each log gives the same solution as one matrix with all parameters of the fit.
// A held-out block has no influence on the nuisance parameters that are removed from its own error.
#include "numerics/elimination.h"

#include "fit/normal_equations.h"
#include "numerics/bounded_least_squares.h"
#include "numerics/gram.h"
#include "numerics/least_squares.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension::fit {
namespace {

constexpr Eigen::Index kSamplesOfLog = 2400;

// Records twelve triangles of 5 s on a spring, with noise. The rig adds an offset, a slow wave and a transient.
gap::PreparedRecord triangles(unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  gap::PreparedRecord record;
  record.dt = 0.025;
  record.mean_frequency = 0.2;
  const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(kSamplesOfLog, 0.0, 60.0);
  record.displacement = (2.0 * element::kPi * 0.2 * time).sin().asin() * (2.0 / element::kPi);
  record.raw_displacement = record.displacement;
  record.force = 3.0 * record.displacement.array() + 0.3 * record.displacement.array().cube();
  for (double& force : record.force) {
    force += 0.03 * normal(generator);
  }
  record.force_deviation = 1.8;
  record.rig.one_deviation = 0.005;
  Eigen::MatrixXd rig(kSamplesOfLog, 3);
  rig.col(0).setConstant(0.05);
  rig.col(1) = 0.05 * (element::kPi / 60.0 * time).cos();
  rig.col(2) = 0.1 * (-time / 2.0).exp();
  record.rig.columns = numerics::whiteningColumns(rig / (record.rig.one_deviation * std::sqrt(kSamplesOfLog)));
  record.force += rig * Eigen::Vector3d(normal(generator), normal(generator), normal(generator));
  return record;
}

std::vector<gap::PreparedRecord> someTriangles(std::size_t count) {
  std::vector<gap::PreparedRecord> records;
  for (std::size_t r = 0; r < count; ++r) {
    records.push_back(triangles(static_cast<unsigned>(r)));
  }
  return records;
}

BlockGrams equationsOf(const std::vector<gap::PreparedRecord>& records, const PerLogNuisances& free,
                       Kept kept = Kept::blocks) {
  std::vector<double> weights;
  gap::Forces base;
  gap::Forces spring;
  gap::Forces one;
  for (const gap::PreparedRecord& record : records) {
    weights.push_back(1.0 /
                      (record.force_deviation * std::sqrt(record.counted() * static_cast<double>(records.size()))));
    base.emplace_back(2.9 * record.displacement);
    spring.push_back(record.displacement);
    one.emplace_back(Eigen::VectorXd::Ones(record.size()));
  }
  return LogBlocks(records, weights).normalEquations(base, {columnOf(spring), columnOf(one)}, {free}, kept, 1).front();
}

Eigen::VectorXd solutionOf(const BlockGrams& blocks) {
  const Eigen::VectorXd bound = Eigen::VectorXd::Constant(blocks.unknowns(), 1e9);
  return solve(blocks.sum, {-bound, bound});
}

// The columns are all parameters and nuisance parameters of the logs; the rows are samples and penalties.
TEST(Elimination, IsTheSolutionWithAllUnknownsInOneMatrix) {
  const std::vector<gap::PreparedRecord> records = someTriangles(3);
  const PerLogNuisances free{true, true, true};
  const Eigen::Index own = free.count();
  const auto logs = static_cast<Eigen::Index>(records.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(logs * (kSamplesOfLog + own), 2 + logs * own);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(all.rows());
  for (Eigen::Index r = 0; r < logs; ++r) {
    const gap::PreparedRecord& record = records[static_cast<std::size_t>(r)];
    const Eigen::VectorXd base = 2.9 * record.displacement;
    const auto rows = Eigen::seqN(r * kSamplesOfLog, kSamplesOfLog);
    all(rows, 0) = record.withoutRig(record.displacement);
    all(rows, 1) = record.withoutRig(Eigen::VectorXd::Ones(kSamplesOfLog));
    right(rows) = record.withoutRig(record.force - base);
    const Eigen::MatrixXd columns = free.columns(record, static_cast<std::size_t>(r), base);
    for (Eigen::Index j = 0; j < own; ++j) {
      all(rows, 2 + r * own + j) = record.withoutRig(columns.col(j));
      all(logs * kSamplesOfLog + r * own + j, 2 + r * own + j) =
          std::sqrt(free.unknowns(record, static_cast<std::size_t>(r), base).penalty[j]);
    }
  }
  const BlockGrams blocks = equationsOf(records, free);
  EXPECT_NEAR(solutionOf(blocks)[0], numerics::solveLeastNorm(all, right)[0], 1e-6);
  EXPECT_EQ(blocks.sum.rows(), 3);  // the size for one log
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3, 3);
  for (const Eigen::MatrixXd& gram : blocks.gram) {
    sum += gram;
  }
  EXPECT_LT((sum - blocks.sum).cwiseAbs().maxCoeff(), 1e-9 * blocks.sum.cwiseAbs().maxCoeff());
}

// The expected error of a held-out block is computed from the covariance of the errors of the rig.
TEST(Elimination, HoldsBlocksOut) {
  const gap::PreparedRecord record = triangles(5);
  const Eigen::MatrixXd c = numerics::columnsOfWhitening(record.rig.columns);
  const Eigen::Index half = kSamplesOfLog / 2;
  std::vector<Eigen::MatrixXd> products;
  for (const Eigen::Index first : {Eigen::Index{0}, half}) {
    Eigen::MatrixXd columns(half, 1 + c.cols());
    columns << record.force.segment(first, half), record.rig.columns.middleRows(first, half);
    products.push_back(numerics::gramOf(columns));
  }
  const numerics::BlockProducts left =
      numerics::withoutErrors(products, numerics::penaltyOfWhitening(record.rig.columns), {{0, 1}, {0.5, 0.5}, 2});
  for (std::size_t b = 0; b < 2; ++b) {
    const auto rows = [&](Eigen::Index block) { return Eigen::seqN(block * half, half); };
    const Eigen::MatrixXd out = c(rows(static_cast<Eigen::Index>(b)), Eigen::all);
    const Eigen::MatrixXd others = c(rows(static_cast<Eigen::Index>(1 - b)), Eigen::all);
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(c.cols(), c.cols());
    const Eigen::MatrixXd known = numerics::Cholesky(identity + others.transpose() * others).solve(identity);
    const Eigen::VectorXd values = known * others.transpose() * record.force(rows(static_cast<Eigen::Index>(1 - b)));
    const Eigen::VectorXd rest = record.force(rows(static_cast<Eigen::Index>(b))) - out * values;
    const Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(half, half) + out * known * out.transpose();
    const double expected = rest.dot(numerics::Cholesky(covariance).solve(rest)) + 0.5 * values.squaredNorm();
    EXPECT_NEAR(left.held_out[b](0, 0), expected, 1e-9 * expected);
  }
}

// For any nuisance parameters, a fit has at least as large an error on held-out blocks as on fitted ones.
TEST(Elimination, LeavesNoLessOfBlocksHeldOutThanInSample) {
  for (const PerLogNuisances& free :
       {PerLogNuisances{}, PerLogNuisances{true}, PerLogNuisances{false, true}, PerLogNuisances{true, true, true}}) {
    for (const std::size_t logs : {1, 2, 5}) {
      const BlockGrams blocks = equationsOf(someTriangles(logs), free);
      const Eigen::VectorXd bound = Eigen::VectorXd::Constant(blocks.unknowns(), 1e9);
      const std::vector<double> errors =
          crossValidate(blocks, [&](const Eigen::MatrixXd& gram) { return solve(gram, {-bound, bound}); });
      const Eigen::VectorXd solution = solutionOf(blocks);
      Eigen::ArrayXd more(static_cast<Eigen::Index>(errors.size()));
      for (std::size_t b = 0; b < errors.size(); ++b) {
        more[static_cast<Eigen::Index>(b)] = errors[b] - squaresLeft(blocks.gram[b], solution) / blocks.weight[b];
      }
      const auto count = static_cast<double>(more.size());
      const double error = std::sqrt((more - more.mean()).square().sum() / (count * (count - 1.0)));
      EXPECT_GT(more.mean(), -2.0 * error) << logs << " logs, " << free.count() << " free";
    }
  }
}

TEST(Elimination, SumsOfFoldsAreThoseOfTheirBlocks) {
  const std::vector<gap::PreparedRecord> records = someTriangles(3);
  const BlockGrams blocks = equationsOf(records, {true, true});
  const BlockGrams folds = equationsOf(records, {true, true}, Kept::folds);
  EXPECT_EQ(folds.blocks, blocks.blocks);
  EXPECT_LT((folds.sum - blocks.sum).cwiseAbs().maxCoeff(), 1e-12);
  for (std::size_t fold = 0; fold < folds.held_out.size(); ++fold) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3, 3);
    for (std::size_t b = 0; b < blocks.held_out.size(); ++b) {
      sum += (blocks.fold[b] == static_cast<int>(fold) ? 1.0 : 0.0) * blocks.held_out[b];
    }
    EXPECT_LT((folds.held_out[fold] - sum).cwiseAbs().maxCoeff(), 1e-12);
  }
}

}  // namespace
}  // namespace rubber_suspension::fit
