// Sizes of the tiles in which products of columns are summed.
#pragma once

#include <cstddef>

namespace rubber_suspension::fit {

constexpr std::size_t kColumnLanes = 8;  // sums that run side by side, on any processor
constexpr std::size_t kTile = 3;         // columns on either side whose sums stay in registers
constexpr std::size_t kTileSums = kTile * kTile * kColumnLanes;

}  // namespace rubber_suspension::fit
