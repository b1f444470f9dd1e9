// Elimination of unknowns of single blocks of samples from normal equations (block-arrow structure): cost and memory
// are those of the common unknowns, however many blocks have unknowns of their own.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::numerics {

/// Products of columns over blocks of samples, and of the residuals of each block after a fit to the others.
struct BlockProducts {
  Eigen::MatrixXd sum;                        ///< of all blocks
  std::vector<Eigen::MatrixXd> without_fold;  ///< of all but those of a fold
  std::vector<Eigen::MatrixXd> in_sample;     ///< of each block; they add up to `sum`
  std::vector<Eigen::MatrixXd> held_out;      ///< of each block, with its own unknowns estimated without its fold
};

/// The fold of each block, and its share in all.
struct BlockPlaces {
  std::vector<int> fold;
  std::vector<double> share;
  int folds = 0;
  bool in_sample = true;  ///< the products in sample are needed, too
};

/// Eliminates U from the `products` of [X U], where U has unknowns of each block with a penalty on their squares, such
/// as measurement errors of unit variance. A held-out block contributes what it adds to the least squares of the
/// others, and its share of the penalty on their solution.
BlockProducts withoutErrors(const std::vector<Eigen::MatrixXd>& products, const Eigen::VectorXd& penalty,
                            const BlockPlaces& places);

/// Eliminates U from the `products` of [X U], where U has the unknowns of a law: a held-out block has the solution of
/// the other folds. `shares` becomes the solution from all blocks for each column of X.
BlockProducts withoutUnknowns(const BlockProducts& products, const Eigen::VectorXd& penalty, const BlockPlaces& places,
                              Eigen::MatrixXd& shares);

/// Merges the blocks of each fold, also in `places`, and drops the products in sample.
BlockProducts byFold(const BlockProducts& products, BlockPlaces& places);

/// Returns the products of a selection of columns.
BlockProducts ofColumns(const BlockProducts& products, const std::vector<Eigen::Index>& columns);

}  // namespace rubber_suspension::numerics
