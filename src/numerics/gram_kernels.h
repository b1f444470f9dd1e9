// Products of columns for one kind of processor (see instruction_sets.h). Every kind adds in eight lanes, so that all
// give the same bits.
#include "processor/lanes.h"

/// Adds the products of three left columns with three right columns to their sums, which have eight lanes.
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

/// Adds the products of left columns with right columns to `sums`, tile by tile. If `same`, left and right are the same
/// columns, and only the upper triangle is added. The number of samples has to be a multiple of eight.
inline void addProducts(const double* const* left, std::size_t left_tiles, const double* const* right,
                        std::size_t right_tiles, bool same, std::size_t count, double* sums) {
  for (std::size_t row = 0; row < left_tiles; ++row) {
    for (std::size_t column = same ? row : 0; column < right_tiles; ++column) {
      addTile(left + row * kTile, right + column * kTile, count, sums);
      sums += kTileSums;
    }
  }
}
