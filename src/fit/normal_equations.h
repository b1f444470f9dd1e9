// Normal equations of a fit by blocks of the logs, and what they tell of data that are left out.
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

/// Normal equations of blocks of the logs, from which any fit that leaves blocks out follows at once. Columns: own
/// parameters, basis terms, and last the residual at the point of linearisation. Unknowns of one log alone, and what
/// the rig may have added to it, are taken out log by log, so that size and time grow with the number of logs, and not
/// with its cube. Each log is weighted such that residuals are in units of its force's standard deviation, and all logs
/// count alike.
struct BlockGrams {
  std::vector<Eigen::MatrixXd> gram;      ///< of each block in sample: with the own unknowns of all blocks
  std::vector<Eigen::MatrixXd> held_out;  ///< with own unknowns that the other folds tell, of blocks or of whole folds
  std::vector<int> fold;                  ///< these and the next are of what `held_out` is of
  std::vector<int> record;
  std::vector<double> weight;  ///< share of the block in all samples, weighted
  Eigen::MatrixXd prior;       ///< what departing from the configured model parameters costs
  Eigen::VectorXd squares;     ///< of each column over all blocks, with what the rig may have added to a log
  std::size_t blocks = 0;
  /// Mean over the logs of the zero of the force [N] and of the gain of each that take a column; empty: they are none.
  Eigen::VectorXd mean_offset;
  Eigen::VectorXd mean_gain;

  Eigen::MatrixXd sum;                        ///< of all blocks and the prior
  std::vector<Eigen::MatrixXd> without_fold;  ///< the same without the blocks of a fold

  Eigen::Index unknowns() const { return sum.rows() - 1; }

  /// Adds the prior to the sums.
  void addPrior();

  /// Fill in the sums by the blocks in sample, which stand for those held out, for kFolds folds at least.
  void sumUp();

  /// Returns the products of a selection of unknowns.
  BlockGrams of(const std::vector<Eigen::Index>& unknowns) const;
};

/// Sums kept of each block, or of each fold. For many columns the latter suffice, and are small.
enum class Kept { blocks, folds };

/// The logs cut into blocks, and the products with each other of columns that no fit changes, found once for all fits.
class LogBlocks {
 public:
  /// The records have to outlive it. `weights`: what makes residuals of each log comparable [1/N].
  LogBlocks(const std::vector<gap::PreparedRecord>& records, std::vector<double> weights,
            std::vector<ForceColumn> known = {}, int threads = 1);

  const std::vector<double>& weights() const { return weights_; }

  /// Normal equations about a model whose forces [N] on the logs are `base`, without a prior. `free`: unknown in each
  /// log, too; one result for each.
  std::vector<BlockGrams> normalEquations(const gap::Forces& base, const std::vector<ForceColumn>& columns,
                                          const std::vector<PerLogNuisances>& free, Kept kept, int threads) const;

 private:
  /// Samples of a log.
  struct Block {
    Eigen::Index first;
    Eigen::Index size;
    double counted;         // samples
    Eigen::MatrixXd known;  // products of the columns that no fit changes, and of what the rig may have added
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
  std::vector<Eigen::VectorXd> penalties_;  // of what the rig may have added to each
};

/// The products of some unknowns with each other and with the residual.
Eigen::MatrixXd ofUnknowns(const Eigen::MatrixXd& gram, std::vector<Eigen::Index> unknowns);

/// The coefficients of all columns but the last that leave least of the last, within bounds.
Eigen::VectorXd solve(const Eigen::MatrixXd& gram, const numerics::Limits& bounds);

/// The squares that coefficients leave of the last column.
double squaresLeft(const Eigen::MatrixXd& gram, const Eigen::VectorXd& coefficients);

/// Held-out mean square error of each block, from its normal equations: each fold is predicted by a fit to the others,
/// whose coefficients `fit` finds.
std::vector<double> crossValidate(const BlockGrams& blocks,
                                  const std::function<Eigen::VectorXd(const Eigen::MatrixXd& gram)>& fit);

}  // namespace rubber_suspension::fit
