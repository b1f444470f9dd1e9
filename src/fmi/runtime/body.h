// What an instance moves: a component of one direction or of six, behind the same calls.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <optional>

#include "fmi/runtime/component_data.h"
#include "fmi/runtime/saved_state.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::fmi {

class Body {
 public:
  /// Throws std::exception where there is no such component.
  explicit Body(const ComponentData& data);

  /// The temperatures [degC] at which its shifts hold.
  element::Range temperatures() const { return six_ ? six_->temperatures() : one_->temperatures(); }

  /// As specified without one [degC].
  void setTemperature(const std::optional<double>& temperature);

  /// False for a rotation beyond the end of its measure.
  bool holds(const Numbers& inputs) const { return !six_ || six_->holds(six_->coordinates(pose(inputs))); }

  /// At rest; gives the outputs. Throws std::invalid_argument where there are none.
  Numbers initialise(const Numbers& inputs);

  /// Gives the outputs; false where they are not finite. Allocates nothing.
  bool step(double size, const Numbers& inputs, Numbers& outputs) {
    if (six_) {
      return stepSix(size, inputs, outputs);
    }
    outputs = numbersOf(one_->step(*state_, size, inputs[0]));
    return std::isfinite(outputs[0]);
  }

  void save(SavedState& state) const;

  /// Throws std::invalid_argument, and leaves this as it was, for a state that it cannot have left.
  void restore(const SavedState& state);

 private:
  static Numbers numbersOf(const element::ComponentForce& force) {
    return {force.total, force.elastic, force.viscous, force.friction};
  }
  static Numbers numbersOf(const component::Wrench& wrench);
  Eigen::Isometry3d pose(const Numbers& inputs) const;
  bool stepSix(double size, const Numbers& inputs, Numbers& outputs);

  std::unique_ptr<const component::Component> one_;
  std::optional<component::ComponentState> state_;
  std::unique_ptr<const component::SixDirections> six_;
  component::SixDirectionsState six_state_;
};

}  // namespace rubber_suspension::fmi
