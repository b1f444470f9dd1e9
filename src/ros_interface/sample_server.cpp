// The topics of one component.
#include "ros_interface/sample_server.h"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <rubber_suspension/MeasuredForce.h>
#include <sensor_msgs/Temperature.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "ros_interface/pose_messages.h"
#include "roscpp_fixes/checked_subscription.h"

namespace rubber_suspension::ros_interface {
namespace {

std::int64_t stampOf(const std_msgs::Header& header) { return static_cast<std::int64_t>(header.stamp.toNSec()); }

bool answerSample(node::ComponentChannel& channel, const Displacement& sample, Force& answer) {
  element::ComponentForce force;
  if (!channel.push(stampOf(sample.header), sample.displacement, force)) {
    return false;
  }
  fillForce(sample, force, answer);
  return true;
}

bool answerSample(node::ComponentChannel& channel, const geometry_msgs::PoseStamped& sample,
                  geometry_msgs::WrenchStamped& answer) {
  component::Wrench wrench;
  if (!channel.push(stampOf(sample.header), vectorOf(sample.pose.position), rotationOf(sample.pose), wrench)) {
    return false;
  }
  answer.header = sample.header;
  answer.wrench = messageOf(wrench);
  return true;
}

}  // namespace

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

template <class Message, class Take>
void SampleServer::subscribe(ros::NodeHandle& handle, const std::string& topic, node::MessageCheck* check, Take take) {
  const boost::function<void(const ros::MessageEvent<const Message>&)> callback = std::move(take);
  subscribers_.push_back(roscpp_fixes::subscribeChecked<Message>(handle, topic, static_cast<std::uint32_t>(queue_size_),
                                                                 check, undecodable_, callback));
}

template <class Sample, class Answer>
void SampleServer::serve(ros::NodeHandle& handle, const std::string& in, const std::string& out,
                         node::MessageCheck* check) {
  publisher_.advertise<Answer>(handle, channel_.name() + out, answerQueueSize(queue_size_));
  subscribe<Sample>(handle, channel_.name() + in, check,
                    [this, pool = std::make_shared<MessagePool<Answer>>()](
                        const ros::MessageEvent<const Sample>& event) { answer(event, *pool); });
}

SampleServer::SampleServer(ros::NodeHandle& handle, node::ComponentChannel& channel, int queue_size)
    : channel_(channel), queue_size_(queue_size) {
  if (channel.hasSixDirections()) {
    serve<geometry_msgs::PoseStamped, geometry_msgs::WrenchStamped>(handle, "/pose", "/wrench",
                                                                    node::isStamped<node::kPoseNumbers>);
    subscribe<geometry_msgs::WrenchStamped>(
        handle, channel.name() + "/measured_wrench", node::isStamped<node::kWrenchNumbers>,
        [&channel](const ros::MessageEvent<const geometry_msgs::WrenchStamped>& event) {
          const geometry_msgs::WrenchStamped& measured = *event.getConstMessage();
          channel.addMeasured(stampOf(measured.header), wrenchOf(measured.wrench));
        });
  } else {
    serve<Displacement, Force>(handle, "/displacement", "/force", node::isStamped<1>);
    subscribe<MeasuredForce>(handle, channel.name() + "/measured_force", node::isStamped<1>,
                             [&channel](const ros::MessageEvent<const MeasuredForce>& event) {
                               const MeasuredForce& measured = *event.getConstMessage();
                               channel.gap().addMeasured(stampOf(measured.header), measured.force);
                             });
  }
  // In the thread of the samples, but in no order with them: the stamps decide.
  subscribe<sensor_msgs::Temperature>(handle, channel.name() + "/temperature", node::isStamped<2>,
                                      [&channel](const ros::MessageEvent<const sensor_msgs::Temperature>& event) {
                                        const sensor_msgs::Temperature& measured = *event.getConstMessage();
                                        channel.setTemperature(stampOf(measured.header), measured.temperature);
                                      });
}

void SampleServer::shutdown() {
  subscribers_.clear();
  publisher_.shutdown();
}

template <class Sample, class Answer>
void SampleServer::answer(const ros::MessageEvent<const Sample>& event, MessagePool<Answer>& pool) {
  const auto callback = std::chrono::steady_clock::now();
  const Sample& sample = *event.getConstMessage();
  if (const std::uint32_t lost = watch_.take(event.getConnectionHeaderPtr(), sample.header.seq)) {
    channel_.countLost(lost);
  }
  const auto message = pool.take();
  if (!answerSample(channel_, sample, *message)) {
    return;
  }
  publisher_.publish(message);
  channel_.countLatency(timeSinceArrival(event.getReceiptTime(), callback));
}

}  // namespace rubber_suspension::ros_interface
