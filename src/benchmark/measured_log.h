// A test piece on a rig, and the component that describes it without its friction.
#pragma once

#include <cstddef>
#include <random>
#include <string>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::benchmark {

/// A component with one Maxwell element; the test piece has friction on top, which the description lacks.
io::ComponentDescription describedComponent();

/// The test piece with noise of the force, the same with every compiler. Its friction has memory, as rubber's: minor
/// loops close.
class MeasuringRig {
 public:
  explicit MeasuringRig(unsigned seed);

  /// The force measured at the next displacement [m], a step later [N].
  double force(double displacement);

 private:
  component::Component test_piece_;
  component::ComponentState state_;
  std::mt19937_64 random_;
};

/// The benchmark's motion times `scale`, and the force measured.
log::Log measuredLog(const std::string& name, std::size_t samples, double scale, unsigned seed);

}  // namespace rubber_suspension::benchmark
