// The topics of one component.
#include "ros_interface/sample_server.h"

#include <chrono>

#include "ros_interface/arrival.h"

namespace rubber_suspension::ros_interface {
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
  publisher_ = handle.advertise<Force>(channel.name() + "/force", size);
  subscriber_ = handle.subscribe(channel.name() + "/displacement", size, &SampleServer::serve, this,
                                 ros::TransportHints().tcpNoDelay());
  measured_subscriber_ = handle.subscribe(channel.name() + "/measured_force", size, &SampleServer::compare, this,
                                          ros::TransportHints().tcpNoDelay());
}

void SampleServer::shutdown() {
  subscriber_.shutdown();
  measured_subscriber_.shutdown();
  publisher_.shutdown();
}

void SampleServer::compare(const MeasuredForce::ConstPtr& measured) {
  channel_.gap().addMeasured(static_cast<std::int64_t>(measured->header.stamp.toNSec()), measured->force);
}

void SampleServer::serve(const ros::MessageEvent<const Displacement>& event) {
  const auto callback = std::chrono::steady_clock::now();
  const Displacement& sample = *event.getConstMessage();
  if (const std::uint32_t lost = watch_.take(event.getConnectionHeaderPtr().get(), sample.header.seq)) {
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
