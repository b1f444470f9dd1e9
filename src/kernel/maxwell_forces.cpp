// Coefficients of Maxwell elements that are simulated together.
#include "kernel/maxwell_forces.h"

#include <algorithm>

#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::kernel {
namespace {

// Step coefficients of several elements, one in each lane.
struct MaxwellLanes {
  static constexpr std::size_t kSize = 8;
  std::size_t count = 0;
  double decay[kSize] = {};
  double gain[kSize] = {};
};

}  // namespace
}  // namespace rubber_suspension::kernel

#define RUBBER_SUSPENSION_LAYER kernel
#define RUBBER_SUSPENSION_KERNELS "kernel/maxwell_forces_kernels.h"
#include "processor/instruction_sets.h"

namespace rubber_suspension::kernel {

void maxwellForces(const std::vector<element::BasicLaws::MaxwellNumbers>& elements, double dt, double start,
                   const double* displacement, std::size_t count, const std::vector<double*>& force) {
  for (std::size_t first = 0; first < elements.size(); first += MaxwellLanes::kSize) {
    MaxwellLanes lanes;
    lanes.count = std::min(MaxwellLanes::kSize, elements.size() - first);
    for (std::size_t e = 0; e < lanes.count; ++e) {
      const auto& [stiffness, rate] = elements[first + e];
      const element::MaxwellStep step(stiffness, element::Relaxation::over(dt * rate));
      lanes.decay[e] = step.decay;
      lanes.gain[e] = step.gain;
    }
    RUBBER_SUSPENSION_KERNEL(stepSideBySide)(lanes, start, displacement, count, force.data() + first);
  }
}

}  // namespace rubber_suspension::kernel
