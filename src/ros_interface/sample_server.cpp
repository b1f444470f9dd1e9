// The topics of one component.
#include "ros_interface/sample_server.h"

#include <rubber_suspension/MeasuredForce.h>
#include <sensor_msgs/Temperature.h>

#include <string>

#include "node/message_bounds.h"
#include "ros_interface/pose_messages.h"

namespace rubber_suspension::ros_interface {
namespace {

std::int64_t stampOf(const std_msgs::Header& header) { return static_cast<std::int64_t>(header.stamp.toNSec()); }

}  // namespace

void fillForce(const Displacement& displacement, const element::ComponentForce& force, Force& message) {
  message.header = displacement.header;
  message.displacement = displacement.displacement;
  message.force = force.total;
  message.elastic = force.elastic;
  message.viscous = force.viscous;
  message.friction = force.friction;
}

bool SampleServer::answer(const Displacement& sample, Force& message) {
  element::ComponentForce force;
  if (!channel_.push(stampOf(sample.header), sample.displacement, force)) {
    return false;
  }
  fillForce(sample, force, message);
  return true;
}

bool SampleServer::answer(const geometry_msgs::PoseStamped& sample, geometry_msgs::WrenchStamped& message) {
  component::Wrench wrench;
  if (!channel_.push(stampOf(sample.header), vectorOf(sample.pose.position), rotationOf(sample.pose), wrench)) {
    return false;
  }
  message.header = sample.header;
  message.wrench = messageOf(wrench);
  return true;
}

SampleServer::SampleServer(ros::NodeHandle& handle, node::ComponentChannel& channel, int queue_size)
    : channel_(channel) {
  const std::string& name = channel.name();
  const auto size = static_cast<std::uint32_t>(queue_size);
  if (channel.hasSixDirections()) {
    using geometry_msgs::PoseStamped;
    using geometry_msgs::WrenchStamped;
    serve<PoseStamped, WrenchStamped>(*this, handle, name + "/pose", size, node::isStamped<node::kPoseNumbers>,
                                      name + "/wrench", answerQueueSize(queue_size));
    subscribe<WrenchStamped>(handle, name + "/measured_wrench", size, node::isStamped<node::kWrenchNumbers>,
                             [&channel](const ros::MessageEvent<const WrenchStamped>& event) {
                               const WrenchStamped& measured = *event.getConstMessage();
                               channel.addMeasured(stampOf(measured.header), wrenchOf(measured.wrench));
                             });
  } else {
    serve<Displacement, Force>(*this, handle, name + "/displacement", size, node::isStamped<1>, name + "/force",
                               answerQueueSize(queue_size));
    subscribe<MeasuredForce>(handle, name + "/measured_force", size, node::isStamped<1>,
                             [&channel](const ros::MessageEvent<const MeasuredForce>& event) {
                               const MeasuredForce& measured = *event.getConstMessage();
                               channel.gap().addMeasured(stampOf(measured.header), measured.force);
                             });
  }
  // The order of temperatures and samples in the queue is not defined, so stamps determine which temperature applies.
  subscribe<sensor_msgs::Temperature>(handle, name + "/temperature", size, node::isStamped<2>,
                                      [&channel](const ros::MessageEvent<const sensor_msgs::Temperature>& event) {
                                        const sensor_msgs::Temperature& measured = *event.getConstMessage();
                                        channel.setTemperature(stampOf(measured.header), measured.temperature);
                                      });
}

}  // namespace rubber_suspension::ros_interface
