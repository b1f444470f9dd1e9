// Gram matrices, a block of samples at a time.
#include "fit/gram.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rubber_suspension::fit {

constexpr std::size_t kColumnLanes = 8;  // sums that run side by side, on any processor
constexpr std::size_t kTile = 3;         // columns on either side whose sums stay in registers
constexpr std::size_t kTileSums = kTile * kTile * kColumnLanes;

}  // namespace rubber_suspension::fit

#define RUBBER_SUSPENSION_LAYER fit
#define RUBBER_SUSPENSION_KERNELS "fit/gram_kernels.h"
#include "processor/instruction_sets.h"

namespace rubber_suspension::fit {
namespace {

constexpr Eigen::Index kBlock = 256;  // samples: two tiles stay in the first-level cache

// Where each column has its samples of a block, in whole tiles; copied and filled with zeros where the block is not
// whole.
std::vector<const double*> block(const Eigen::Ref<const Eigen::MatrixXd>& columns, Eigen::Index first,
                                 std::size_t tiles, std::vector<double>& copy) {
  const Eigen::Index count = std::min(kBlock, columns.rows() - first);
  const bool whole = count == kBlock;
  copy.assign(static_cast<std::size_t>((whole ? 1 : columns.cols() + 1) * kBlock), 0.0);
  std::vector<const double*> places(tiles * kTile, copy.data());  // the first of the copies is of zeros
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

}  // namespace

Eigen::MatrixXd gramOf(const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  const auto tiles = (static_cast<std::size_t>(columns.cols()) + kTile - 1) / kTile;
  std::vector<double> sums(tiles * (tiles + 1) / 2 * kTileSums, 0.0);
  std::vector<double> copy;
  for (Eigen::Index first = 0; first < columns.rows(); first += kBlock) {
    const std::vector<const double*> places = block(columns, first, tiles, copy);
    RUBBER_SUSPENSION_KERNEL(addGram)(places.data(), tiles, static_cast<std::size_t>(kBlock), sums.data());
  }
  Eigen::MatrixXd gram(columns.cols(), columns.cols());
  const double* tile = sums.data();
  for (std::size_t row = 0; row < tiles; ++row) {
    for (std::size_t column = row; column < tiles; ++column, tile += kTileSums) {
      for (std::size_t place = 0; place < kTile * kTile; ++place) {
        const auto i = static_cast<Eigen::Index>(row * kTile + place / kTile);
        const auto j = static_cast<Eigen::Index>(column * kTile + place % kTile);
        if (i < gram.rows() && j < gram.cols()) {
          const double* const lanes = tile + place * kColumnLanes;
          gram(i, j) = gram(j, i) = std::accumulate(lanes, lanes + kColumnLanes, 0.0);
        }
      }
    }
  }
  return gram;
}

}  // namespace rubber_suspension::fit
