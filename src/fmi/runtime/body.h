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

  bool isSix() const { return six_ != nullptr; }

  /// Gives the outputs; false where they are not finite. Allocates nothing.
  bool step(double size, const Numbers& inputs, Numbers& outputs);

  /// The same of one direction, faster.
  bool stepOne(double size, double displacement, Numbers& outputs) {
    const element::ComponentForce force = one_->step(*state_, size, displacement);
    outputs[0] = force.total;
    outputs[1] = force.elastic;
    outputs[2] = force.viscous;
    outputs[3] = force.friction;
    return std::isfinite(force.total);
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

  std::unique_ptr<const component::Component> one_;
  std::optional<component::ComponentState> state_;
  std::unique_ptr<const component::SixDirections> six_;
  component::SixDirectionsState six_state_;
};

}  // namespace rubber_suspension::fmi
