// Normal equations of a fit by blocks of the logs, and what they tell of data that are left out.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "fit/free_in_log.h"
#include "numerics/trust_region.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

constexpr int kFolds = 4;

/// Normal equations of blocks of the logs, from which any fit that leaves blocks out follows at once. Columns: own
/// parameters, basis terms, what is free in each log, and last the residual at the point of linearisation. Each log is
/// weighted such that residuals are in units of its force's standard deviation, and all logs count alike.
struct BlockGrams {
  std::vector<Eigen::MatrixXd> gram;
  std::vector<int> fold;
  std::vector<int> record;
  std::vector<double> weight;  ///< share of the block in all samples, weighted
  Eigen::MatrixXd prior;       ///< what departing from the configured model parameters costs
  Eigen::VectorXd squares;     ///< of each column over all blocks, with what the rig may have added to a log

  Eigen::MatrixXd sum;                        ///< of all blocks and the prior
  std::vector<Eigen::MatrixXd> without_fold;  ///< the same without the blocks of a fold

  Eigen::Index unknowns() const { return gram[0].rows() - 1; }

  /// Fill in the sums, for kFolds folds at least.
  void sumUp();

  /// Those of some of the unknowns alone.
  BlockGrams of(const std::vector<Eigen::Index>& unknowns) const;
};

/// The logs cut into blocks, and the products with each other of columns that no fit changes, found once for all fits.
class LogBlocks {
 public:
  /// The records have to outlive it. `weights`: what makes residuals of each log comparable [1/N].
  LogBlocks(const std::vector<log::Record>& records, std::vector<double> weights, std::vector<ForceColumn> known = {},
            int threads = 1);

  const std::vector<double>& weights() const { return weights_; }

  /// Normal equations about a model whose forces [N] on the logs are `base`. `free`: unknown in each log, too. The
  /// prior is that of trends and of zeros of the displacement alone.
  BlockGrams normalEquations(const gap::Forces& base, const std::vector<ForceColumn>& columns, const FreeInLog& free,
                             int threads) const;

 private:
  /// Samples of a log.
  struct Block {
    Eigen::Index first;
    Eigen::Index size;
    Eigen::MatrixXd known;  // products of the columns that no fit changes, and of what the rig may have added
  };
  struct Request;
  static std::vector<Block> cut(const log::Record& record);
  Eigen::MatrixXd ownOf(const Request& request, std::size_t r) const;
  std::vector<Eigen::MatrixXd> productsIn(std::size_t r, const Request& request) const;
  Eigen::MatrixXd priorOf(const Request& request) const;

  const std::vector<log::Record>& records_;
  std::vector<double> weights_;
  std::vector<ForceColumn> known_;
  std::vector<std::vector<Block>> blocks_;  // of each log
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
