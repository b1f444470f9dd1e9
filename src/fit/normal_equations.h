// Normal equations of a fit by blocks of the logs, and the held-out errors that follow from them.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "fit/free_in_log.h"
#include "numerics/trust_region.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

constexpr int kFolds = 4;

/// Normal equations of blocks of the logs, from which a fit without some of the blocks follows directly. Their columns
/// are model parameters, basis terms, and last the residual at the point of linearisation. Nuisance parameters of a log
/// and errors of its rig are eliminated for each log, so that size and time grow linearly with the number of logs. Logs
/// are weighted such that residuals are in units of the standard deviation of the log's force, and all logs count
/// alike.
struct BlockGrams {
  std::vector<Eigen::MatrixXd> gram;      ///< products of each block, with nuisances fitted to all blocks
  std::vector<Eigen::MatrixXd> held_out;  ///< products of each block or fold, with nuisances fitted to other folds
  std::vector<int> fold;                  ///< fold of each entry of `held_out`
  std::vector<int> record;
  std::vector<double> weight;  ///< share of each entry of `held_out` in all samples, weighted
  Eigen::MatrixXd prior;       ///< contribution of the prior of the model parameters
  Eigen::VectorXd squares;     ///< sum of squares of each column over all blocks, with errors of the rig
  std::size_t blocks = 0;
  /// Means over the logs of force offset [N] and gain to which each column is equivalent; empty if not fitted.
  Eigen::VectorXd mean_offset;
  Eigen::VectorXd mean_gain;

  Eigen::MatrixXd sum;                        ///< sum of all blocks and the prior
  std::vector<Eigen::MatrixXd> without_fold;  ///< sum without the blocks of each fold

  Eigen::Index unknowns() const { return sum.rows() - 1; }

  /// Adds the prior to the sums.
  void addPrior();

  /// Computes the sums from the blocks in `gram`, which also become the held-out blocks, for at least kFolds folds.
  void sumUp();

  /// Returns the products of a selection of columns.
  BlockGrams of(const std::vector<Eigen::Index>& unknowns) const;
};

/// Entries of BlockGrams::held_out: either blocks, or folds, which need less memory and suffice for many columns.
enum class Kept { blocks, folds };

/// Cuts logs into blocks. Products of columns that no fit changes are computed once for all fits.
class LogBlocks {
 public:
  /// The records have to outlive this object. `weights`: factors that make residuals of the logs comparable [1/N].
  LogBlocks(const std::vector<gap::PreparedRecord>& records, std::vector<double> weights,
            std::vector<ForceColumn> known = {}, int threads = 1);

  const std::vector<double>& weights() const { return weights_; }

  /// Returns the normal equations, without a prior, at a model whose forces on the logs are `base` [N]: one result for
  /// each entry of `free`, the nuisance parameters fitted to each log.
  std::vector<BlockGrams> normalEquations(const gap::Forces& base, const std::vector<ForceColumn>& columns,
                                          const std::vector<PerLogNuisances>& free, Kept kept, int threads) const;

 private:
  /// A range of samples of a log.
  struct Block {
    Eigen::Index first;
    Eigen::Index size;
    double counted;         // number of samples that count
    Eigen::MatrixXd known;  // products of the columns that no fit changes and of errors of the rig
  };
  struct Request;
  static std::vector<Block> cut(const log::Record& record, std::size_t logs);
  struct OfLog;
  Eigen::MatrixXd ownOf(const Request& request, std::size_t r) const;
  std::vector<Eigen::MatrixXd> productsIn(std::size_t r, const Request& request) const;
  OfLog ofLog(std::size_t r, const Request& request) const;
  void add(std::size_t r, const OfLog& of_log, const Request& request, const PerLogNuisances& free,
           BlockGrams& result) const;

  const std::vector<gap::PreparedRecord>& records_;
  std::vector<double> weights_;
  std::vector<ForceColumn> known_;
  std::vector<std::vector<Block>> blocks_;  // blocks of each log
  std::vector<Eigen::VectorXd> penalties_;  // penalties on the errors of the rig of each log
};

/// Returns the products of some columns with each other and with the residual.
Eigen::MatrixXd ofUnknowns(const Eigen::MatrixXd& gram, std::vector<Eigen::Index> unknowns);

/// Returns the coefficients, within bounds, with which the other columns fit the last column best.
Eigen::VectorXd solve(const Eigen::MatrixXd& gram, const numerics::Limits& bounds);

/// Returns the sum of squares of the last column minus the other columns times their coefficients.
double squaresLeft(const Eigen::MatrixXd& gram, const Eigen::VectorXd& coefficients);

/// Returns the held-out mean square error of each block. Each fold is predicted with the coefficients that `fit`
/// returns for the normal equations of the other folds.
std::vector<double> crossValidate(const BlockGrams& blocks,
                                  const std::function<Eigen::VectorXd(const Eigen::MatrixXd& gram)>& fit);

}  // namespace rubber_suspension::fit
