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

/// Normal equations of blocks of the logs, from which any fit without some of the blocks follows at once. Columns:
/// model parameters, basis terms, and last the residual at the point of linearisation. Nuisance parameters of a log and
/// errors of its rig are eliminated log by log, so that size and time grow with the number of logs, and not with its
/// cube. Each log is weighted such that residuals are in units of its force's standard deviation, and all logs count
/// alike.
struct BlockGrams {
  std::vector<Eigen::MatrixXd> gram;      ///< of each block in sample: its log's unknowns are fitted to all blocks
  std::vector<Eigen::MatrixXd> held_out;  ///< of each block or fold: the log's unknowns are fitted to the other folds
  std::vector<int> fold;                  ///< of each entry of `held_out`, as the next two
  std::vector<int> record;
  std::vector<double> weight;  ///< share of the block in all samples, weighted
  Eigen::MatrixXd prior;       ///< products of the prior of the model parameters
  Eigen::VectorXd squares;     ///< of each column over all blocks, including errors of the rig
  std::size_t blocks = 0;
  /// Mean over the logs of the force offset [N], and of the gain, that each column is equivalent to; empty: not free.
  Eigen::VectorXd mean_offset;
  Eigen::VectorXd mean_gain;

  Eigen::MatrixXd sum;                        ///< of all blocks and the prior
  std::vector<Eigen::MatrixXd> without_fold;  ///< the same without the blocks of a fold

  Eigen::Index unknowns() const { return sum.rows() - 1; }

  /// Adds the prior to the sums.
  void addPrior();

  /// Computes the sums from the blocks in sample, which are also the held-out ones, for at least kFolds folds.
  void sumUp();

  /// Returns the products of a selection of unknowns.
  BlockGrams of(const std::vector<Eigen::Index>& unknowns) const;
};

/// Entries of BlockGrams::held_out: blocks, or folds, which need less memory and suffice for many columns.
enum class Kept { blocks, folds };

/// Cuts logs into blocks, and computes the products of columns that no fit changes once for all fits.
class LogBlocks {
 public:
  /// The records have to outlive it. `weights`: factors that make residuals of the logs comparable [1/N].
  LogBlocks(const std::vector<gap::PreparedRecord>& records, std::vector<double> weights,
            std::vector<ForceColumn> known = {}, int threads = 1);

  const std::vector<double>& weights() const { return weights_; }

  /// Returns the normal equations about a model whose forces [N] on the logs are `base`, without a prior, for each
  /// entry of `free`, which is then free in each log.
  std::vector<BlockGrams> normalEquations(const gap::Forces& base, const std::vector<ForceColumn>& columns,
                                          const std::vector<PerLogNuisances>& free, Kept kept, int threads) const;

 private:
  /// Samples of a log.
  struct Block {
    Eigen::Index first;
    Eigen::Index size;
    double counted;         // samples
    Eigen::MatrixXd known;  // products of the columns that no fit changes, and of errors of the rig
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
  std::vector<std::vector<Block>> blocks_;  // of each log
  std::vector<Eigen::VectorXd> penalties_;  // on the errors of the rig of each log
};

/// Returns the products of some unknowns with each other and with the residual.
Eigen::MatrixXd ofUnknowns(const Eigen::MatrixXd& gram, std::vector<Eigen::Index> unknowns);

/// Returns the coefficients, within bounds, with which all other columns fit the last one best.
Eigen::VectorXd solve(const Eigen::MatrixXd& gram, const numerics::Limits& bounds);

/// Returns the sum of squares of the last column minus the others times the coefficients.
double squaresLeft(const Eigen::MatrixXd& gram, const Eigen::VectorXd& coefficients);

/// Returns the held-out mean square error of each block: each fold is predicted with the coefficients that `fit` finds
/// from the normal equations of the others.
std::vector<double> crossValidate(const BlockGrams& blocks,
                                  const std::function<Eigen::VectorXd(const Eigen::MatrixXd& gram)>& fit);

}  // namespace rubber_suspension::fit
