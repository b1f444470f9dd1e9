// The component that an instance simulates. Its calls are the same for one direction and for six directions.
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
  /// Stores the calculated parameters and builds the component. Throws std::exception for data without a component.
  Body(const ComponentData& data, std::vector<double> calculated);

  const std::vector<double>& calculated() const { return calculated_; }

  /// Returns the temperatures [degC] at which the shifts of the component are valid.
  element::Range temperatures() const { return six_ ? six_->temperatures() : one_->temperatures(); }
  void setTemperature(double temperature) {
    six_ ? six_->setTemperature(six_state_, temperature) : one_->setTemperature(one_state_, temperature);
  }

  /// Initialises the component at rest, without history, at a temperature [degC] or, if none is given, as specified.
  /// Returns the outputs. Throws std::invalid_argument if an output is not finite or a rotation is out of range.
  Numbers initialise(const Numbers& inputs, const std::optional<double>& temperature);

  /// Advances by a step [s] and sets the outputs. Returns false if an output is not finite. Allocates nothing. For a
  /// rotation beyond the range of its measure, throws std::invalid_argument and changes nothing.
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

  /// Restores a state. If this component cannot have saved it, throws std::invalid_argument and changes nothing.
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
