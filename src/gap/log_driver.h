// Drives a component over records and logs at even steps, whole or piece by piece. Logs with stamps are simulated by
// component::SampleStream, as in the node.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "log/even_blocks.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/radial_stiffness.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::gap {

/// The past of a component where a log begins: it is new, or it has relaxed since the log before.
enum class Before { nothing, another_log };

/// Drives a component over one log after another. The component follows temperature and displacement across, if the log
/// has them and the component depends on them.
class LogDriver {
 public:
  /// Throws std::invalid_argument for elements that are no component.
  explicit LogDriver(const std::vector<element::ElementDescription>& elements)
      : component_(elements), radial_(element::radialLaws(elements)), state_(component_.makeState()) {}

  /// Begins a log with the next piece. The lead-in of an excerpt has to exist until that is driven.
  void begin(Before before, const log::LeadIn* lead_in = nullptr);

  /// Computes the force at each sample of a piece of the log [N], with this sampling interval [s]. A time gap before
  /// the piece is one step, as in `replay` and the node.
  void drive(const log::EvenBlocks::Piece& piece, double dt, double* force);

  /// Returns the force over a whole record [N], driven by this displacement [m]. A displacement longer than the record
  /// begins before it, with the first value of temperature and of displacement across.
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
  std::vector<double> led_in_;  // forces of the lead-in, of no further use
};

}  // namespace rubber_suspension::gap
