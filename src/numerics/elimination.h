// Unknowns that some blocks of samples have for themselves, taken out of normal equations (block-arrow structure): cost
// and memory are those of the other unknowns, however many parts of the samples have their own.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::numerics {

/// Products of columns over blocks of samples, and what a fit to other blocks leaves of each block.
struct BlockProducts {
  Eigen::MatrixXd sum;                        ///< of all blocks
  std::vector<Eigen::MatrixXd> without_fold;  ///< of all but those of a fold
  std::vector<Eigen::MatrixXd> in_sample;     ///< of each block; they add up to `sum`
  std::vector<Eigen::MatrixXd> held_out;      ///< of each block, its own unknowns found without those of its fold
};

/// The fold of each block, and its share in all.
struct BlockPlaces {
  std::vector<int> fold;
  std::vector<double> share;
  int folds = 0;
  bool in_sample = true;  ///< the products in sample are wanted, too
};

/// Those of the columns X where `products` are of [X U]: U times unknowns with a penalty on their squares, such as
/// errors of the measurement of unit variance, of which each block may have its own as far as other folds leave that
/// open. A block held out then leaves what it adds to the least squares of the others, and its share of the penalty of
/// what these found.
BlockProducts withoutErrors(const std::vector<Eigen::MatrixXd>& products, const Eigen::VectorXd& penalty,
                            const BlockPlaces& places);

/// Those of X where `products` are of [X U], U times unknowns of a law: a block held out has those of the other folds.
/// `shares`: becomes what all blocks give of U for each column of X.
BlockProducts withoutUnknowns(const BlockProducts& products, const Eigen::VectorXd& penalty, const BlockPlaces& places,
                              Eigen::MatrixXd& shares);

/// The blocks of each fold as one; none in sample.
BlockProducts byFold(const BlockProducts& products, BlockPlaces& places);

/// Those of some of the columns.
BlockProducts ofColumns(const BlockProducts& products, const std::vector<Eigen::Index>& columns);

}  // namespace rubber_suspension::numerics
