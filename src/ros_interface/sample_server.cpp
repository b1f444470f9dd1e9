// The topics of one component.
#include "ros_interface/sample_server.h"

#include <rubber_suspension/MeasuredForce.h>
#include <sensor_msgs/Temperature.h>

#include <algorithm>

#include "node/message_bounds.h"
#include "roscpp_fixes/checked_subscription.h"

namespace rubber_suspension::ros_interface {

// More than what may wait on the input, so that what has been accepted is not lost on its way out.
std::uint32_t answerQueueSize(int queue_size) {
  constexpr std::uint32_t kFewest = 40000;
  return std::max(kFewest, 4 * static_cast<std::uint32_t>(queue_size));
}

std::int64_t timeSinceArrival(const ros::Time& receipt, std::chrono::steady_clock::time_point callback) {
  if (ros::Time::isSystemTime()) {
    return std::max<std::int64_t>(0, (ros::Time::now() - receipt).toNSec());
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - callback).count();
}

void fillForce(const Displacement& displacement, const element::ComponentForce& force, Force& message) {
  message.header = displacement.header;
  message.displacement = displacement.displacement;
  message.force = force.total;
  message.elastic = force.elastic;
  message.viscous = force.viscous;
  message.friction = force.friction;
}

SampleServer::SampleServer(ros::NodeHandle& handle, node::ComponentChannel& channel, int queue_size)
    : channel_(channel) {
  const auto size = static_cast<std::uint32_t>(queue_size);
  publisher_.advertise<Force>(handle, channel.name() + "/force", answerQueueSize(queue_size));
  subscribers_ = {
      roscpp_fixes::subscribeChecked<Displacement>(
          handle, channel.name() + "/displacement", size, node::isStampedNumber, undecodable_,
          [this](const ros::MessageEvent<const Displacement>& event) { serve(event); }),
      roscpp_fixes::subscribeChecked<MeasuredForce>(
          handle, channel.name() + "/measured_force", size, node::isStampedNumber, undecodable_,
          [&channel](const ros::MessageEvent<const MeasuredForce>& event) {
            const MeasuredForce& measured = *event.getConstMessage();
            channel.gap().addMeasured(static_cast<std::int64_t>(measured.header.stamp.toNSec()), measured.force);
          }),
      // In the thread of the samples, but in no order with them: the stamps decide.
      roscpp_fixes::subscribeChecked<sensor_msgs::Temperature>(
          handle, channel.name() + "/temperature", size, node::isStampedPair, undecodable_,
          [&channel](const ros::MessageEvent<const sensor_msgs::Temperature>& event) {
            const sensor_msgs::Temperature& measured = *event.getConstMessage();
            channel.setTemperature(static_cast<std::int64_t>(measured.header.stamp.toNSec()), measured.temperature);
          })};
}

void SampleServer::shutdown() {
  subscribers_.clear();
  publisher_.shutdown();
}

void SampleServer::serve(const ros::MessageEvent<const Displacement>& event) {
  const auto callback = std::chrono::steady_clock::now();
  const Displacement& sample = *event.getConstMessage();
  if (const std::uint32_t lost = watch_.take(event.getConnectionHeaderPtr(), sample.header.seq)) {
    channel_.countLost(lost);
  }
  element::ComponentForce force;
  if (!channel_.push(static_cast<std::int64_t>(sample.header.stamp.toNSec()), sample.displacement, force)) {
    return;
  }
  const auto message = pool_.take();
  fillForce(sample, force, *message);
  publisher_.publish(message);
  channel_.countLatency(timeSinceArrival(event.getReceiptTime(), callback));
}

}  // namespace rubber_suspension::ros_interface
