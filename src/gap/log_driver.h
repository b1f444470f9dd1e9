// Drives a component over records and logs with even time steps, whole or piece by piece. Logs with uneven stamps are
// simulated by component::SampleStream, as in the node.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "log/even_blocks.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/radial_stiffness.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::gap {

/// States whether a component is new where a log begins, or has relaxed since the previous log.
enum class Before { nothing, another_log };

/// Drives a component over one log after another. The component follows the temperature and the displacement across if
/// the log contains them and the component depends on them.
class LogDriver {
 public:
  /// Throws std::invalid_argument if no component can have these elements.
  explicit LogDriver(const std::vector<element::ElementDescription>& elements)
      : component_(elements), radial_(element::radialLaws(elements)), state_(component_.makeState()) {}

  /// Begins a new log with the next piece. `lead_in` has to exist until that piece has been driven.
  void begin(Before before, const log::LeadIn* lead_in = nullptr);

  /// Computes the force at each sample of a piece of the log [N]. `dt` is the sampling interval [s]. A time gap before
  /// the piece is simulated as one step, as in `replay` and the node.
  void drive(const log::EvenBlocks::Piece& piece, double dt, double* force);

  /// Returns the force over a whole record [N] for this displacement [m]. If the displacement is longer than the
  /// record, it begins earlier, and temperature and displacement across have their first value until the record begins.
  Eigen::VectorXd over(const log::Record& record, const Eigen::VectorXd& displacement, Before before);

 private:
  bool follows(const log::EvenBlocks::Piece& piece) const {
    return component_.shiftsWithTemperature() && piece.temperature != nullptr;
  }
  double rest(double displacement);
  void leadIn();

  component::Component component_;
  std::vector<element::RadialStiffness> radial_;
  component::ComponentState state_;
  Before before_ = Before::nothing;
  const log::LeadIn* lead_in_ = nullptr;
  bool begins_ = true;
  std::vector<double> led_in_;  // forces of the lead-in, which are not used
};

}  // namespace rubber_suspension::gap
