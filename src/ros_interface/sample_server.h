// The topics of one component: a force for every displacement that its channel accepts.
#pragma once

#include <ros/node_handle.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/Force.h>
#include <rubber_suspension/MeasuredForce.h>

#include "node/component_channel.h"
#include "node/sequence_watch.h"
#include "ros_interface/message_pool.h"

namespace rubber_suspension::ros_interface {

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

 private:
  void serve(const ros::MessageEvent<const Displacement>& event);
  void compare(const MeasuredForce::ConstPtr& measured);

  node::ComponentChannel& channel_;
  MessagePool<Force> pool_;
  node::SequenceWatch watch_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  ros::Subscriber measured_subscriber_;
};

}  // namespace rubber_suspension::ros_interface
