// The body that an instance moves: a component of one direction or of six, behind the same calls.
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "fmi/runtime/component_data.h"
#include "fmi/runtime/saved_state.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::fmi {

class Body {
 public:
  /// With the parameters that follow from those of the data. Throws std::exception where there is no such component.
  Body(const ComponentData& data, std::vector<double> calculated);

  const std::vector<double>& calculated() const { return calculated_; }

  /// Temperatures [degC] at which its shifts are valid.
  element::Range temperatures() const { return six_ ? six_->temperatures() : one_->temperatures(); }
  void setTemperature(double temperature) {
    six_ ? six_->setTemperature(six_state_, temperature) : one_->setTemperature(one_state_, temperature);
  }

  /// Initialises at rest, never moved before, at a temperature [degC] or as specified, and returns the outputs. Throws
  /// std::invalid_argument if there are none.
  Numbers initialise(const Numbers& inputs, const std::optional<double>& temperature);

  /// Advances and sets the outputs; returns false if they are not finite. Allocates nothing. Throws
  /// std::invalid_argument, without any change, for a rotation beyond the end of its measure.
  bool step(double size, const Numbers& inputs, Numbers& outputs) {
    if (six_) {
      return stepSix(size, inputs, outputs);
    }
    const element::ComponentForce force = one_->step(one_state_, size, inputs[0]);
    outputs[0] = force.total;
    outputs[1] = force.elastic;
    outputs[2] = force.viscous;
    outputs[3] = force.friction;
    return std::isfinite(force.total);
  }

  void save(SavedState& state) const;

  /// Restores a state. Throws std::invalid_argument, without any change, for one that it cannot have saved.
  void restore(const SavedState& state);

 private:
  bool stepSix(double size, const Numbers& inputs, Numbers& outputs);
  Eigen::Isometry3d pose(const Numbers& inputs) const;

  std::vector<double> calculated_;
  std::optional<component::Component> one_;
  component::ComponentState one_state_;
  std::optional<component::SixDirections> six_;
  component::SixDirectionsState six_state_;
};

}  // namespace rubber_suspension::fmi
