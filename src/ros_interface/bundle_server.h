// All components in one message: topics `displacements` and `forces`, for simulations that step all at once.
#pragma once

#include <ros/node_handle.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/ForceArray.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "node/component_channel.h"
#include "ros_interface/message_pool.h"

namespace rubber_suspension::ros_interface {

/// Answer a bundle: a force for every displacement that its component accepts. False, and no component has seen
/// anything, where the message is malformed: a name that no component has, or lists of unequal length.
/// Allocates nothing once `answer` has held as many components before.
bool answerBundle(const DisplacementArray& bundle, const std::vector<node::ComponentChannel*>& channels,
                  ForceArray& answer);

/// Serves the two topics in the thread of the handle's callback queue, by the same components as the single topics.
class BundleServer {
 public:
  /// The channels must outlive the server.
  BundleServer(ros::NodeHandle& handle, const std::vector<node::ComponentChannel*>& channels, int queue_size);

  /// Take no more samples.
  void shutdown();

  std::uint64_t answered() const { return answered_; }    ///< messages
  std::uint64_t malformed() const { return malformed_; }  ///< messages that were dropped

 private:
  void serve(const ros::MessageEvent<const DisplacementArray>& event);

  std::vector<node::ComponentChannel*> channels_;
  MessagePool<ForceArray> pool_;
  std::atomic<std::uint64_t> answered_{0};
  std::atomic<std::uint64_t> malformed_{0};
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace rubber_suspension::ros_interface
