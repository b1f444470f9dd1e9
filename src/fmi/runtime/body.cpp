// Calls that are the same for a component of one direction and one of six directions.
#include "fmi/runtime/body.h"

#include "element/refuse.h"

namespace rubber_suspension::fmi {
namespace {

bool areFinite(const Numbers& numbers) { return Eigen::Map<const component::SixNumbers>(numbers.data()).allFinite(); }

Numbers numbersOf(const component::Wrench& wrench) {
  return {wrench.force.x(),  wrench.force.y(),  wrench.force.z(),
          wrench.moment.x(), wrench.moment.y(), wrench.moment.z()};
}

}  // namespace

Body::Body(const ComponentData& data, std::vector<double> calculated) : calculated_(std::move(calculated)) {
  if (data.six) {
    six_.emplace(*data.six);
    six_state_ = six_->makeState();
  } else {
    one_.emplace(data.allElements());
    one_state_ = one_->makeState();
  }
}

Numbers Body::initialise(const Numbers& inputs, const std::optional<double>& temperature) {
  if (temperature) {
    setTemperature(*temperature);
  }
  if (six_) {
    const Numbers outputs = numbersOf(six_->initialise(six_state_, pose(inputs)).wrench);
    element::refuseIf(!areFinite(outputs), "the pose gives a wrench that is not finite");
    return outputs;
  }
  const element::ComponentForce force = one_->initialise(one_state_, inputs[0]);
  const Numbers outputs = {force.total, force.elastic, force.viscous, force.friction};
  element::refuseIf(!areFinite(outputs), "displacement {:g} m gives a force that is not finite", inputs[0]);
  return outputs;
}

bool Body::stepSix(double size, const Numbers& inputs, Numbers& outputs) {
  outputs = numbersOf(six_->step(six_state_, size, pose(inputs)).wrench);
  return areFinite(outputs);
}

void Body::save(SavedState& state) const {
  if (six_) {
    state.memory = six_state_.numbers();
  } else {
    state.component_displacement = one_state_.displacement();
    one_state_.saveMemory(state.memory);
  }
}

void Body::restore(const SavedState& state) {
  if (six_) {
    six_->restore(six_state_, state.memory);
  } else {
    one_->restore(one_state_, state.component_displacement, state.memory);
  }
}

// Returns the pose of body B. Throws std::invalid_argument for a rotation beyond the range of its measure.
Eigen::Isometry3d Body::pose(const Numbers& inputs) const {
  const component::SixNumbers numbers = Eigen::Map<const component::SixNumbers>(inputs.data());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = numbers.head<3>();
  pose.linear() = component::rotationOf(six_->laws().measure, numbers.tail<3>()).toRotationMatrix();
  element::refuseIf(!six_->holds(six_->coordinates(pose)),
                    "the rotation exceeds the range of rotation vectors or cardan angles");
  return pose;
}

}  // namespace rubber_suspension::fmi
