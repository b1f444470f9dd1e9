// A component of one direction or of six behind the same calls.
#include "fmi/runtime/body.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "element/refuse.h"

namespace rubber_suspension::fmi {
namespace {

bool areFinite(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

}  // namespace

Body::Body(const ComponentData& data) {
  if (data.six) {
    six_ = std::make_unique<const component::SixDirections>(*data.six);
    six_state_ = six_->makeState();
  } else {
    one_ = std::make_unique<const component::Component>(data.allElements());
    state_ = one_->makeState();
  }
}

void Body::setTemperature(const std::optional<double>& temperature) {
  if (one_ && !temperature) {
    one_->forgetTemperature(*state_);
  } else if (one_) {
    one_->setTemperature(*state_, *temperature);
  } else if (temperature) {
    six_->setTemperature(six_state_, *temperature);
  }
}

Numbers Body::initialise(const Numbers& inputs) {
  element::refuseIf(!holds(inputs), "a rotation beyond the end of its measure");
  const Numbers outputs = six_ ? numbersOf(six_->initialise(six_state_, pose(inputs)).wrench)
                               : numbersOf(one_->initialise(*state_, inputs[0]));
  if (!areFinite(outputs)) {
    throw std::invalid_argument(six_ ? "the pose gives a wrench that is not finite"
                                     : fmt::format("displacement {:g} m gives a force that is not finite", inputs[0]));
  }
  return outputs;
}

bool Body::step(double size, const Numbers& inputs, Numbers& outputs) {
  if (!six_) {
    return stepOne(size, inputs[0], outputs);
  }
  outputs = numbersOf(six_->step(six_state_, size, pose(inputs)).wrench);
  return areFinite(outputs);
}

void Body::save(SavedState& state) const {
  if (six_) {
    state.memory = six_state_.numbers();
  } else {
    state.component_displacement = state_->displacement();
    state.memory = state_->memory();
  }
}

void Body::restore(const SavedState& state) {
  if (six_) {
    six_->restore(six_state_, state.memory);
  } else {
    one_->restore(*state_, state.component_displacement, state.memory);
  }
}

Numbers Body::numbersOf(const component::Wrench& wrench) {
  return {wrench.force.x(),  wrench.force.y(),  wrench.force.z(),
          wrench.moment.x(), wrench.moment.y(), wrench.moment.z()};
}

Eigen::Isometry3d Body::pose(const Numbers& inputs) const {
  const component::SixNumbers numbers = Eigen::Map<const component::SixNumbers>(inputs.data());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = numbers.head<3>();
  pose.linear() = component::rotationOf(six_->laws().measure, numbers.tail<3>()).toRotationMatrix();
  return pose;
}

}  // namespace rubber_suspension::fmi
