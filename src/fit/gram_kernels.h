// Products of all columns with each other, for one kind of processor. Sums run over eight lanes on each of them, so
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

/// Adds the products of all columns, tile by tile of the upper triangle, to their sums. The number of samples is a
/// multiple of eight.
inline void addGram(const double* const* columns, std::size_t tiles, std::size_t count, double* sums) {
  for (std::size_t row = 0; row < tiles; ++row) {
    for (std::size_t column = row; column < tiles; ++column) {
      addTile(columns + row * kTile, columns + column * kTile, count, sums);
      sums += kTileSums;
    }
  }
}
