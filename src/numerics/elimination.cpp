// Elimination of the variables of single blocks by Cholesky factors.
#include "numerics/elimination.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "numerics/symmetric.h"

namespace rubber_suspension::numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Raises the penalty so that variables that no block determines become 0; the effect on the others is negligible.
VectorXd withMinimumPenalty(const VectorXd& penalty, const MatrixXd& sum) {
  constexpr double kLeast = 1e-10;  // share of the sum over all blocks
  constexpr double kNothing = 1e-300;
  const VectorXd least = (kLeast * sum.diagonal().tail(penalty.size())).cwiseMax(kNothing);
  return penalty.cwiseMax(least);
}

// Returns the eliminated variables that minimise the residual of each column of X.
MatrixXd eliminate(const MatrixXd& products, const VectorXd& penalty) {
  const Index own = penalty.size();
  MatrixXd gram = products.bottomRightCorner(own, own);
  gram.diagonal() += penalty;
  return Cholesky(gram).solve(MatrixXd(products.bottomLeftCorner(own, products.cols() - own)));
}

// Returns the Schur complement: products of the residuals at the optimal eliminated variables, with their penalty.
MatrixXd schurComplement(const MatrixXd& products, const MatrixXd& shares) {
  const Index width = shares.cols();
  return products.topLeftCorner(width, width) - products.topRightCorner(width, shares.rows()) * shares;
}

// Returns the products of the residuals X - U shares for arbitrary `shares`.
MatrixXd residualProducts(const MatrixXd& products, const MatrixXd& shares) {
  const Index own = shares.rows();
  const Index width = shares.cols();
  const MatrixXd across = products.bottomLeftCorner(own, width);
  const MatrixXd rest = across - products.bottomRightCorner(own, own) * shares;
  return products.topLeftCorner(width, width) - across.transpose() * shares - shares.transpose() * rest;
}

MatrixXd costOf(const MatrixXd& shares, const VectorXd& penalty) {
  return shares.transpose() * penalty.asDiagonal() * shares;
}

MatrixXd sumOf(const std::vector<MatrixXd>& products) {
  MatrixXd sum = products.front();
  std::for_each(products.begin() + 1, products.end(), [&](const MatrixXd& one) { sum += one; });
  return sum;
}

// Adds the blocks of all other folds, rather than subtracting from the sum, so that zeros remain exact.
std::vector<MatrixXd> sumsWithoutFold(const std::vector<MatrixXd>& products, const BlockPlaces& places) {
  std::vector<MatrixXd> sums(static_cast<std::size_t>(places.folds),
                             MatrixXd::Zero(products.front().rows(), products.front().cols()));
  for (std::size_t b = 0; b < products.size(); ++b) {
    for (std::size_t fold = 0; fold < sums.size(); ++fold) {
      if (static_cast<int>(fold) != places.fold[b]) {
        sums[fold] += products[b];
      }
    }
  }
  return sums;
}

}  // namespace

BlockProducts withoutErrors(const std::vector<MatrixXd>& products, const VectorXd& penalty, const BlockPlaces& places) {
  const MatrixXd sum = sumOf(products);
  const std::vector<MatrixXd> training = sumsWithoutFold(products, places);
  if (penalty.size() == 0) {
    return {sum, training, products, products};
  }
  BlockProducts result;
  const VectorXd all = withMinimumPenalty(penalty, sum);
  const MatrixXd shares = eliminate(sum, all);
  const MatrixXd cost = costOf(shares, all);
  std::vector<MatrixXd> cost_without;
  result.sum = schurComplement(sum, shares);
  for (const MatrixXd& others : training) {
    const MatrixXd found = eliminate(others, all);
    result.without_fold.push_back(schurComplement(others, found));
    cost_without.push_back(costOf(found, all));
  }
  for (std::size_t b = 0; b < products.size(); ++b) {
    const auto fold = static_cast<std::size_t>(places.fold[b]);
    const MatrixXd with = training[fold] + products[b];
    if (places.in_sample) {
      result.in_sample.push_back(residualProducts(products[b], shares) + places.share[b] * cost);
    }
    result.held_out.push_back(schurComplement(with, eliminate(with, all)) - result.without_fold[fold] +
                              places.share[b] * cost_without[fold]);
  }
  return result;
}

BlockProducts withoutUnknowns(const BlockProducts& products, const VectorXd& penalty, const BlockPlaces& places,
                              MatrixXd& shares) {
  const VectorXd all = withMinimumPenalty(penalty, products.sum);
  shares = eliminate(products.sum, all);
  const MatrixXd cost = costOf(shares, all);
  BlockProducts result;
  result.sum = schurComplement(products.sum, shares);
  std::vector<MatrixXd> found;
  for (const MatrixXd& others : products.without_fold) {
    found.push_back(eliminate(others, all));
    result.without_fold.push_back(schurComplement(others, found.back()));
  }
  for (std::size_t b = 0; b < products.held_out.size(); ++b) {
    const MatrixXd& of_others = found[static_cast<std::size_t>(places.fold[b])];
    if (places.in_sample) {
      result.in_sample.push_back(residualProducts(products.in_sample[b], shares) + places.share[b] * cost);
    }
    result.held_out.push_back(residualProducts(products.held_out[b], of_others));
  }
  return result;
}

BlockProducts byFold(const BlockProducts& products, BlockPlaces& places) {
  BlockProducts result{products.sum, products.without_fold, {}, {}};
  result.held_out.assign(static_cast<std::size_t>(places.folds),
                         MatrixXd::Zero(products.sum.rows(), products.sum.cols()));
  for (std::size_t b = 0; b < products.held_out.size(); ++b) {
    result.held_out[static_cast<std::size_t>(places.fold[b])] += products.held_out[b];
  }
  places.fold.resize(result.held_out.size());
  std::iota(places.fold.begin(), places.fold.end(), 0);
  places.in_sample = false;
  return result;
}

BlockProducts ofColumns(const BlockProducts& products, const std::vector<Index>& columns) {
  const auto part = [&](const MatrixXd& all) -> MatrixXd { return all(columns, columns); };
  const auto parts = [&](const std::vector<MatrixXd>& all) {
    std::vector<MatrixXd> result;
    std::transform(all.begin(), all.end(), std::back_inserter(result), part);
    return result;
  };
  return {part(products.sum), parts(products.without_fold), parts(products.in_sample), parts(products.held_out)};
}

}  // namespace rubber_suspension::numerics
