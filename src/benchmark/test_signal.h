// Displacements and stamps that all cases share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rubber_suspension::benchmark {

constexpr double kStep = 1e-3;  ///< sampling interval [s]

/// Three sines of 1.3, 4 and 17 Hz with 2 mm in all, from zero; friction turns some 20 times per second.
std::vector<double> benchmarkDisplacement(std::size_t samples);

/// Stamps [ns] every millisecond, or with steps between 0.7 and 1.3 ms of which no two in a row are equal (fixed seed).
enum class Stamps { even, uneven };
std::vector<std::int64_t> stampsOf(Stamps kind, std::size_t samples);

}  // namespace rubber_suspension::benchmark
