// Acceptance of stamped poses.
#include "rubber_suspension/component/pose_stream.h"

#include <cmath>

#include "element/largest_number.h"

namespace rubber_suspension::component {

Eigen::Isometry3d poseOf(const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = position;
  pose.linear() = rotation.normalized().toRotationMatrix();
  return pose;
}

PoseStream::PoseStream(const SixDirections& component, double max_gap)
    : StampedStream(max_gap), component_(component), state_(component.makeState()), saved_(state_) {}

BushForce PoseStream::advance(Acceptance acceptance, std::int64_t stamp, const Eigen::Isometry3d& pose) {
  saved_.copyFrom(state_);
  return !started_ || acceptance == Acceptance::restarted
             ? component_.initialise(state_, pose)
             : component_.step(state_, secondsBetween(last_stamp_, stamp), pose);
}

StreamWrench PoseStream::push(std::int64_t stamp, const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation) {
  StreamWrench result{judge(stamp, position.allFinite() && rotation.coeffs().allFinite()), {}, SixNumbers::Zero()};
  if (isAccepted(result.acceptance) && !(std::abs(rotation.norm() - 1.0) <= kQuaternionTolerance)) {
    result.acceptance = Acceptance::not_a_rotation;
  }
  if (isAccepted(result.acceptance)) {
    const Eigen::Isometry3d pose = poseOf(position, rotation);
    result.coordinates = component_.coordinates(pose);
    if (!component_.holds(result.coordinates)) {
      result.acceptance = Acceptance::beyond_measure;
    } else if (position.lpNorm<Eigen::Infinity>() > element::kLargestNumber) {
      result.acceptance = Acceptance::force_not_finite;  // after a delay the force would not be finite
    } else {
      result.force = advance(result.acceptance, stamp, pose);
      if (!result.force.wrench.force.allFinite() || !result.force.wrench.moment.allFinite()) {
        state_.copyFrom(saved_);
        result = {Acceptance::force_not_finite, {}, SixNumbers::Zero()};
      }
    }
  }
  if (isAccepted(result.acceptance)) {
    last_stamp_ = stamp;
    started_ = true;
    result.beyond_valid = !component_.isValid(result.coordinates);
    beyond_valid_ += result.beyond_valid ? 1 : 0;
  }
  count(result.acceptance);
  return result;
}

bool PoseStream::setTemperature(double temperature) {
  if (component_.shiftsWithTemperature() && !component_.temperatures().contains(temperature)) {
    return false;
  }
  component_.setTemperature(state_, temperature);
  return true;
}

void PoseStream::reset() {
  component_.initialise(state_, component_.pose(SixNumbers::Zero()));
  started_ = false;
}

void PoseStream::deserialise(std::int64_t last_stamp, const std::vector<double>& numbers) {
  component_.restore(state_, numbers);
  last_stamp_ = last_stamp;
  started_ = true;
}

}  // namespace rubber_suspension::component
