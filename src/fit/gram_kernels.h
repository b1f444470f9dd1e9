// Products of all columns with each other, for one kind of processor. See instruction_sets.h.
#include "fit/tile_kernels.h"

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
