// Columns of unit forces and of their derivatives over a block of samples, and products of columns, for one kind of
// processor. Sums run over eight lanes on each of them, so that all give the same bits. See instruction_sets.h.
#include "fit/tile_kernels.h"

/// Forces of Berg friction of unit maximum and their derivatives by ln(z2), two columns, from sample `first` of the log
/// on; `branch` is the one that this sample is on, and the last sample's is returned. What is written beyond the last
/// sample has no meaning.
inline const FrictionBranch* followBranches(const FrictionBranch* branch, const double* way, std::size_t first,
                                            std::size_t count, double* columns) {
  constexpr double kTiny =
      std::numeric_limits<double>::min();  // keeps 0/0 away at a reference point without force left
  double* const force = columns;
  double* const change = columns + kColumnStride;
  for (std::size_t i = 0; i < count;) {
    branch += first + i >= branch->end ? 1 : 0;
    const std::size_t end = branch->end - first < count ? branch->end - first : count;
    const Lanes left = spread(branch->left);
    const Lanes reach = spread(branch->reach) + kTiny;
    const Lanes left_change = spread(branch->left_change);
    const Lanes reach_pull = spread(branch->left * branch->reach_change);
    for (; i < end; i += kWidth) {
      const Lanes distance = load(way + first + i);
      const Lanes inverse = 1.0 / (reach + distance);
      const Lanes part = distance * inverse;
      store(branch->force + part * left, force + i);
      store(branch->force_change + part * (left_change - reach_pull * inverse), change + i);
    }
    i = end;
  }
  return branch;
}

/// Adds the products of all columns, three by three, to their sums, but for those among the first three columns, which
/// are the same in each pass. The number of samples is a multiple of eight.
inline void addProducts(const double* const* columns, std::size_t tiles, std::size_t count, double* sums) {
  for (std::size_t row = 0; row < tiles; ++row) {
    for (std::size_t column = row; column < tiles; ++column) {
      if (column > 0) {
        addTile(columns + row * kTile, columns + column * kTile, count, sums);
      }
      sums += kTileSums;
    }
  }
}
