// All components in one message: topics `displacements` and `forces`, for simulations that step all at once.
#pragma once

#include <ros/node_handle.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/ForceArray.h>

#include <atomic>
#include <cstdint>

#include "node/channel_group.h"
#include "node/sequence_watch.h"
#include "ros_interface/message_pool.h"
#include "roscpp_fixes/answer_publisher.h"

namespace rubber_suspension::ros_interface {

/// Answer a bundle: a force for every displacement that its component accepts. False, and no component has seen
/// anything, where the message is malformed: a name that no component has, or lists of unequal length.
/// Nothing saves or changes all components meanwhile. Allocates nothing once `answer` has held as many components
/// before.
bool answerBundle(const DisplacementArray& bundle, const node::ChannelGroup& group, ForceArray& answer);

/// Serves the two topics in the thread of the handle's callback queue, by the same components as the single topics.
class BundleServer {
 public:
  /// The group must outlive the server.
  BundleServer(ros::NodeHandle& handle, const node::ChannelGroup& group, int queue_size);

  /// Take no more samples.
  void shutdown();

  std::uint64_t answered() const { return answered_; }    ///< messages
  std::uint64_t malformed() const { return malformed_; }  ///< messages dropped: unknown names, lists of unequal length
  std::uint64_t lost() const { return lost_; }  ///< messages that were sent but never arrived, as for single samples
  std::uint64_t undecodable() const { return undecodable_; }              ///< messages dropped that are no bundles
  std::uint64_t undelivered() const { return publisher_.undelivered(); }  ///< answers; see AnswerPublisher

 private:
  void serve(const ros::MessageEvent<const DisplacementArray>& event);

  const node::ChannelGroup& group_;
  MessagePool<ForceArray> pool_;
  std::atomic<std::uint64_t> answered_{0};
  std::atomic<std::uint64_t> malformed_{0};
  node::SequenceWatch<boost::shared_ptr<ros::M_string>> watch_;
  std::atomic<std::uint64_t> lost_{0};
  std::atomic<std::uint64_t> undecodable_{0};
  roscpp_fixes::AnswerPublisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace rubber_suspension::ros_interface
