// Products of columns, computed for one block of samples at a time.
#include "numerics/gram.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rubber_suspension::numerics {

constexpr std::size_t kColumnLanes = 8;  // number of sums in vector lanes, equal on all processors
constexpr std::size_t kTile = 3;         // columns of each factor whose sums stay in registers
constexpr std::size_t kTileSums = kTile * kTile * kColumnLanes;

}  // namespace rubber_suspension::numerics

#define RUBBER_SUSPENSION_LAYER numerics
#define RUBBER_SUSPENSION_KERNELS "numerics/gram_kernels.h"
#include "processor/instruction_sets.h"

namespace rubber_suspension::numerics {
namespace {

constexpr Eigen::Index kBlock = 256;  // samples; two tiles fit into the first-level cache

// Returns pointers to the samples of each column in a block, for whole tiles. An incomplete block is copied and padded
// with zeros.
std::vector<const double*> block(const Eigen::Ref<const Eigen::MatrixXd>& columns, Eigen::Index first,
                                 std::size_t tiles, std::vector<double>& copy) {
  const Eigen::Index count = std::min(kBlock, columns.rows() - first);
  const bool whole = count == kBlock;
  copy.assign(static_cast<std::size_t>((whole ? 1 : columns.cols() + 1) * kBlock), 0.0);
  std::vector<const double*> places(tiles * kTile, copy.data());  // the first block of `copy` contains zeros
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    const double* const samples = columns.col(j).data() + first;
    double* const to = copy.data() + (whole ? 0 : j + 1) * kBlock;
    if (!whole) {
      std::copy(samples, samples + count, to);
    }
    places[static_cast<std::size_t>(j)] = whole ? samples : to;
  }
  return places;
}

using Columns = Eigen::Ref<const Eigen::MatrixXd>;

Eigen::MatrixXd product(const Columns& left, const Columns& right, bool same) {
  const auto tilesOf = [](const Columns& columns) {
    return (static_cast<std::size_t>(columns.cols()) + kTile - 1) / kTile;
  };
  const std::size_t rows = tilesOf(left);
  const std::size_t columns = tilesOf(right);
  std::vector<double> sums((same ? rows * (rows + 1) / 2 : rows * columns) * kTileSums, 0.0);
  const auto add = RUBBER_SUSPENSION_KERNEL(addProducts);
  std::vector<double> left_copy;
  std::vector<double> right_copy;
  for (Eigen::Index first = 0; first < left.rows(); first += kBlock) {
    const std::vector<const double*> of_left = block(left, first, rows, left_copy);
    const std::vector<const double*> of_right = same ? of_left : block(right, first, columns, right_copy);
    add(of_left.data(), rows, of_right.data(), columns, same, static_cast<std::size_t>(kBlock), sums.data());
  }
  Eigen::MatrixXd result(left.cols(), right.cols());
  const double* tile = sums.data();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = same ? row : 0; column < columns; ++column, tile += kTileSums) {
      for (std::size_t place = 0; place < kTile * kTile; ++place) {
        const auto i = static_cast<Eigen::Index>(row * kTile + place / kTile);
        const auto j = static_cast<Eigen::Index>(column * kTile + place % kTile);
        if (i < result.rows() && j < result.cols()) {
          const double* const lanes = tile + place * kColumnLanes;
          result(i, j) = std::accumulate(lanes, lanes + kColumnLanes, 0.0);
        }
      }
    }
  }
  return result;
}

}  // namespace

Eigen::MatrixXd gramOf(const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  Eigen::MatrixXd gram = product(columns, columns, true);
  gram.triangularView<Eigen::StrictlyLower>() = gram.transpose().triangularView<Eigen::StrictlyLower>();
  return gram;
}

Eigen::MatrixXd productOf(const Eigen::Ref<const Eigen::MatrixXd>& left,
                          const Eigen::Ref<const Eigen::MatrixXd>& right) {
  return product(left, right, false);
}

}  // namespace rubber_suspension::numerics
