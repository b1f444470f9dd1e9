// The topics of one component: a force for every displacement that its channel accepts, or a wrench for every pose.
#pragma once

#include <ros/node_handle.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/Force.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "node/component_channel.h"
#include "node/message_bounds.h"
#include "node/sequence_watch.h"
#include "ros_interface/message_pool.h"
#include "roscpp_fixes/answer_publisher.h"

namespace rubber_suspension::ros_interface {

/// Answers that may wait for a subscriber that reads slowly, where that many samples may wait for the node.
std::uint32_t answerQueueSize(int queue_size);

/// From the arrival of a message to now [ns]. ROS stamps arrivals with ros::Time, which stands for real time only while
/// no simulated time is in use; then what is known is the time since `callback`, when the message's callback began.
std::int64_t timeSinceArrival(const ros::Time& receipt, std::chrono::steady_clock::time_point callback);

/// Write the answer to a displacement.
void fillForce(const Displacement& displacement, const element::ComponentForce& force, Force& message);

/// Answers in the thread that serves the handle's callback queue; never blocks and, once its messages are in use,
/// allocates nothing of its own.
class SampleServer {
 public:
  /// `channel` must outlive the server.
  SampleServer(ros::NodeHandle& handle, node::ComponentChannel& channel, int queue_size);

  /// Take no more samples.
  void shutdown();

  /// Messages on the topics of the component that are no samples, measured forces or temperatures; dropped.
  std::uint64_t undecodable() const { return undecodable_; }

  /// Forces that a subscriber did not get because it reads too slowly.
  std::uint64_t undelivered() const { return publisher_.undelivered(); }

 private:
  template <class Sample, class Answer>
  void serve(ros::NodeHandle& handle, const std::string& in, const std::string& out, node::MessageCheck* check);
  template <class Sample, class Answer>
  void answer(const ros::MessageEvent<const Sample>& event, MessagePool<Answer>& pool);
  template <class Message, class Take>
  void subscribe(ros::NodeHandle& handle, const std::string& topic, node::MessageCheck* check, Take take);

  node::ComponentChannel& channel_;
  int queue_size_;
  node::SequenceWatch<boost::shared_ptr<ros::M_string>> watch_;
  std::atomic<std::uint64_t> undecodable_{0};
  roscpp_fixes::AnswerPublisher publisher_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace rubber_suspension::ros_interface
