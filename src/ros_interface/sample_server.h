// The topics of one component: a force for every displacement that its channel accepts, or a wrench for every pose.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/node_handle.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/Force.h>

#include <cstdint>

#include "node/component_channel.h"
#include "ros_interface/answering_topics.h"

namespace rubber_suspension::ros_interface {

void fillForce(const Displacement& displacement, const element::ComponentForce& force, Force& message);

class SampleServer : public AnsweringTopics {
 public:
  /// `channel` must outlive the server.
  SampleServer(ros::NodeHandle& handle, node::ComponentChannel& channel, int queue_size);

 private:
  friend AnsweringTopics;

  bool answer(const Displacement& sample, Force& message);
  bool answer(const geometry_msgs::PoseStamped& sample, geometry_msgs::WrenchStamped& message);
  void countLost(std::uint32_t samples) { channel_.countLost(samples); }
  template <class Answer>
  void countAnswered(const Answer& /*answer*/, std::int64_t latency) {
    channel_.countLatency(latency);
  }

  node::ComponentChannel& channel_;
};

}  // namespace rubber_suspension::ros_interface
