// Stress softening.
#include "rubber_suspension/element/stress_softening.h"

#include <algorithm>
#include <cmath>

#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

enum Slot { kLargest, kReach };

}  // namespace

StressSoftening::StressSoftening(double reduction, double width, double path)
    : reduction_(reduction), width_(width), path_(path), deepest_(std::tanh(1.0 / width)) {}

void StressSoftening::initialise(double displacement, double* memory) const {
  memory[kLargest] = memory[kReach] = std::abs(displacement);
}

// Softening is permanent: only a displacement beyond all before counts anew.
double StressSoftening::relax(double displacement, double* memory) const {
  memory[kLargest] = std::max(memory[kLargest], std::abs(displacement));
  if (path_ == 0.0) {
    memory[kReach] = memory[kLargest];
  }
  return factor(displacement, memory[kReach]);
}

double StressSoftening::factor(double displacement, double reach) const {
  if (std::abs(displacement) >= reach) {
    return 1.0;
  }
  const double ratio = displacement / reach;
  return 1.0 - reduction_ * std::tanh((1.0 - ratio * ratio) / width_) / deepest_;
}

double StressSoftening::step(const Motion& motion, const ComponentForce& /*force*/, double* memory) const {
  memory[kLargest] = std::max(memory[kLargest], std::abs(motion.displacement));
  const double kept = path_ > 0.0 ? Relaxation::over(std::abs(motion.increment) / path_).decay : 0.0;
  memory[kReach] += (memory[kLargest] - memory[kReach]) * (1.0 - kept);
  return factor(motion.displacement, memory[kReach]);
}

ElementType stressSofteningType() {
  return {"stress_softening",
          "Mullins effect: softer within displacements that were reached before.",
          {{"reduction", "1", Role::shape, Range::closed(0.0, 0.9), std::nullopt,
            "share R of the force that is lost deep within"},
           {"width", "1", Role::shape, Range::closed(0.01, 10.0), 0.5,
            "width w of the transition, as a share of the energy at the largest past displacement"},
           {"path", "m", Role::shape, Range::nonNegative(), 0.0, "travel over which softening sets in; 0: at once"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const StressSoftening>(description.value("reduction"), description.value("width"),
                                                           description.value("path"));
          }};
}

}  // namespace rubber_suspension::element
