// Products of columns with columns, for one kind of processor. Sums run over eight lanes on each of them, so
// that all give the same bits. See instruction_sets.h.
#include "processor/lanes.h"

/// Adds the products of three columns with three others to their sums over eight lanes.
inline void addTile(const double* const* left, const double* const* right, std::size_t count, double* sums) {
  for (std::size_t lane = 0; lane < kColumnLanes; lane += kWidth) {
    Lanes sum[kTile][kTile] = {};
    for (std::size_t i = lane; i < count; i += kColumnLanes) {
      const Lanes a[kTile] = {load(left[0] + i), load(left[1] + i), load(left[2] + i)};
      for (std::size_t k = 0; k < kTile; ++k) {
        const Lanes b = load(right[k] + i);
        for (std::size_t j = 0; j < kTile; ++j) {
          sum[j][k] += a[j] * b;
        }
      }
    }
    for (std::size_t j = 0; j < kTile; ++j) {
      for (std::size_t k = 0; k < kTile; ++k) {
        double* const to = sums + (j * kTile + k) * kColumnLanes + lane;
        store(load(to) + sum[j][k], to);
      }
    }
  }
}

/// Adds the products of left columns with right columns to `sums`, tile by tile. If both are the same columns, it adds
/// only the upper triangle. The number of samples is a multiple of eight.
inline void addProducts(const double* const* left, std::size_t left_tiles, const double* const* right,
                        std::size_t right_tiles, bool same, std::size_t count, double* sums) {
  for (std::size_t row = 0; row < left_tiles; ++row) {
    for (std::size_t column = same ? row : 0; column < right_tiles; ++column) {
      addTile(left + row * kTile, right + column * kTile, count, sums);
      sums += kTileSums;
    }
  }
}
