// Elimination of the variables of single blocks of samples from normal equations (block-arrow structure). Cost and
// memory are as for the common variables alone, however many blocks have variables of their own.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::numerics {

/// Products of columns over blocks of samples, and over each block with variables estimated from other folds.
struct BlockProducts {
  Eigen::MatrixXd sum;                        ///< sum of all blocks
  std::vector<Eigen::MatrixXd> without_fold;  ///< sum of all blocks outside of each fold
  std::vector<Eigen::MatrixXd> in_sample;     ///< products of each block, which add up to `sum`
  std::vector<Eigen::MatrixXd> held_out;      ///< products of each block, with its variables estimated from other folds
};

/// Fold and weight of each block.
struct BlockPlaces {
  std::vector<int> fold;
  std::vector<double> share;
  int folds = 0;
  bool in_sample = true;  ///< true if BlockProducts::in_sample is needed
};

/// Eliminates U from the `products` of [X U]. U contains variables of each block with a penalty on their squares, such
/// as measurement errors of unit variance. A held-out block contributes what it adds to the least squares of the other
/// blocks, and its share of the penalty of their solution.
BlockProducts withoutErrors(const std::vector<Eigen::MatrixXd>& products, const Eigen::VectorXd& penalty,
                            const BlockPlaces& places);

/// Eliminates U from the `products` of [X U]. U contains the variables of a law, for which a held-out block uses the
/// solution of the other folds. `shares` becomes the solution from all blocks for each column of X.
BlockProducts withoutUnknowns(const BlockProducts& products, const Eigen::VectorXd& penalty, const BlockPlaces& places,
                              Eigen::MatrixXd& shares);

/// Merges the blocks of each fold, also in `places`. The result contains no in_sample.
BlockProducts byFold(const BlockProducts& products, BlockPlaces& places);

/// Returns the products of a selection of columns.
BlockProducts ofColumns(const BlockProducts& products, const std::vector<Eigen::Index>& columns);

}  // namespace rubber_suspension::numerics
