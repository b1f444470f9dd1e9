// Coefficients of Maxwell elements for a small step, for one kind of processor. See instruction_sets.h.
#include "processor/lanes.h"
#include "rubber_suspension/element/relaxation_mean.h"

/// Computes MaxwellStep by Relaxation::small for `count` elements with rates [1/s] and stiffnesses [N/m].
inline void prepareSmall(double dt, const double* rate, const double* stiffness, std::size_t count,
                         MaxwellBlock* block) {
  for (std::size_t i = 0; i < count; i += kWidth) {
    const Lanes ratio = dt * load(rate + i);
    const Lanes mean = meanOverSmallStep(ratio);
    MaxwellBlock& target = block[i / MaxwellBlock::kSize];
    const std::size_t place = i % MaxwellBlock::kSize;
    store(1.0 - ratio * mean, reinterpret_cast<double*>(target.decay) + place);
    store(load(stiffness + i) * mean, reinterpret_cast<double*>(target.gain) + place);
  }
}
