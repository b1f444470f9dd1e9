// Normal equations of a fit by blocks of the logs, and what they tell of data that are left out.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "fit/free_in_log.h"
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

  /// Fill in the sums, for kFolds folds at least.
  void sumUp();
};

/// Derivative of the force by an unknown, per log; null: zero everywhere.
using ForceColumn = std::shared_ptr<const std::vector<Eigen::VectorXd>>;

/// Products with each other of columns that no fit changes, found once for all fits to the same logs.
class KnownColumns {
 public:
  /// `weights` as for normalEquations().
  KnownColumns(const std::vector<log::Record>& records, const std::vector<double>& weights,
               std::vector<ForceColumn> columns, int threads);

  /// Place of a column among them, -1 for others.
  Eigen::Index find(const ForceColumn& column) const;

  /// Of a block, once what the rig may have added is taken out.
  const Eigen::MatrixXd& products(std::size_t block) const { return products_[block]; }
  /// By how much each nuisance of its log is in each column of a block, and of the whole log.
  const Eigen::MatrixXd& onNuisances(std::size_t block) const { return on_nuisances_[block]; }
  const Eigen::MatrixXd& shares(std::size_t record) const { return shares_[record]; }
  /// Of each column over all blocks, with what the rig may have added.
  double squares(Eigen::Index column) const;

 private:
  std::vector<ForceColumn> columns_;
  std::map<const std::vector<Eigen::VectorXd>*, Eigen::Index> places_;
  std::vector<Eigen::MatrixXd> products_;
  std::vector<Eigen::MatrixXd> on_nuisances_;
  std::vector<Eigen::MatrixXd> shares_;
  std::vector<Eigen::VectorXd> squares_;  // of each record
};

/// Normal equations about a model whose forces [N] on the logs are `base`, without prior. `weights`: what makes
/// residuals of each log comparable [1/N]. `free`: unknown in each log, too; `by_zero` as in Hypothesis. `known`: of
/// the same logs; may be null. The prior is that of trends and of zeros of the displacement.
BlockGrams normalEquations(const std::vector<log::Record>& records, const std::vector<double>& weights,
                           const std::vector<Eigen::VectorXd>& base, const std::vector<ForceColumn>& columns,
                           FreeInLog free, int threads, const KnownColumns* known = nullptr,
                           const ForceColumn& by_zero = nullptr);

/// The coefficients of some columns within bounds that leave least of the last column, by the products of all columns.
Eigen::VectorXd solveColumns(const Eigen::MatrixXd& gram, const std::vector<Eigen::Index>& columns,
                             const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// The same of all columns.
Eigen::VectorXd solveAll(const Eigen::MatrixXd& gram, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// The squares that coefficients of some columns leave of the last column.
double squaresLeft(const Eigen::MatrixXd& gram, const std::vector<Eigen::Index>& columns,
                   const Eigen::VectorXd& coefficients);

/// Held-out mean square error of each block, from its normal equations: each fold is predicted by a fit to the others,
/// for which `solve` finds the coefficients of these columns.
std::vector<double> crossValidate(const BlockGrams& blocks, const std::vector<Eigen::Index>& columns,
                                  const std::function<Eigen::VectorXd(const Eigen::MatrixXd& gram)>& solve);

/// The same by solveColumns().
std::vector<double> crossValidate(const BlockGrams& blocks, const std::vector<Eigen::Index>& columns,
                                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

}  // namespace rubber_suspension::fit
