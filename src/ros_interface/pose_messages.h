// Conversion of poses and wrenches between messages and Eigen types.
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Wrench.h>

#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::ros_interface {

template <class Message>
Eigen::Vector3d vectorOf(const Message& message) {
  return {message.x, message.y, message.z};
}

template <class Message>
void fill(Message& message, const Eigen::Vector3d& vector) {
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
}

inline Eigen::Quaterniond rotationOf(const geometry_msgs::Pose& pose) {
  return {pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z};
}

inline geometry_msgs::Pose messageOf(const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation) {
  geometry_msgs::Pose message;
  fill(message.position, position);
  fill(message.orientation, rotation.vec());
  message.orientation.w = rotation.w();
  return message;
}

inline component::Wrench wrenchOf(const geometry_msgs::Wrench& message) {
  return {vectorOf(message.force), vectorOf(message.torque)};
}

inline geometry_msgs::Wrench messageOf(const component::Wrench& wrench) {
  geometry_msgs::Wrench message;
  fill(message.force, wrench.force);
  fill(message.torque, wrench.moment);
  return message;
}

}  // namespace rubber_suspension::ros_interface
