// Separate forces of Maxwell elements, for one kind of processor. See instruction_sets.h.
#include "processor/lanes.h"
#include "rubber_suspension/element/maxwell_force.h"

/// Simulates several elements together from rest, and writes the forces of each element to its own array.
inline void stepSideBySide(const MaxwellLanes& elements, double start, const double* displacement, std::size_t count,
                           double* const* force) {
  constexpr std::size_t kVectors = MaxwellLanes::kSize / kWidth;
  constexpr std::size_t kBlock = 64;  // samples that are transposed together
  double rows[kBlock][MaxwellLanes::kSize];
  Lanes decay[kVectors];
  Lanes gain[kVectors];
  Lanes forces[kVectors] = {};
  for (std::size_t k = 0; k < kVectors; ++k) {
    decay[k] = load(elements.decay + k * kWidth);
    gain[k] = load(elements.gain + k * kWidth);
  }
  double last = start;
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::size_t size = count - first < kBlock ? count - first : kBlock;
    for (std::size_t i = 0; i < size; ++i) {
      const double increment = displacement[first + i] - last;
      last = displacement[first + i];
      for (std::size_t k = 0; k < kVectors; ++k) {
        forces[k] = maxwellForce(decay[k], gain[k], forces[k], increment);
        store(forces[k], rows[i] + k * kWidth);
      }
    }
    for (std::size_t e = 0; e < elements.count; ++e) {
      for (std::size_t i = 0; i < size; ++i) {
        *(force[e] + first + i) = rows[i][e];
      }
    }
  }
}
