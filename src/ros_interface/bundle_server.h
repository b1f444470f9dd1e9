// Server of the bundled topics, whose messages concern all components at once: `displacements` and `forces`, or `poses`
// and `wrenches`.
#pragma once

#include <ros/node_handle.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/ForceArray.h>
#include <rubber_suspension/PoseArray.h>
#include <rubber_suspension/WrenchArray.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "node/channel_group.h"
#include "ros_interface/answering_topics.h"

namespace rubber_suspension::ros_interface {

/// Answers a bundle with a force for every displacement, or a wrench for every pose, that its component accepts.
/// Returns false and changes no component if the message is malformed: it has an unknown name or lists of unequal
/// length. Operations on all components wait until this function returns. Allocates nothing if `answer` had as many
/// components before.
bool answerBundle(const DisplacementArray& bundle, const node::ChannelGroup& group, ForceArray& answer);
bool answerBundle(const PoseArray& bundle, const node::ChannelGroup& group, WrenchArray& answer);

/// Serves the two bundled topics with the components that also serve the single topics.
class BundleServer : public AnsweringTopics {
 public:
  /// The group must outlive the server.
  BundleServer(ros::NodeHandle& handle, const node::ChannelGroup& group, int queue_size, bool six_directions);

  std::uint64_t answered() const { return answered_; }    ///< number of answered messages
  std::uint64_t malformed() const { return malformed_; }  ///< number of malformed messages
  std::uint64_t lost() const { return lost_; }            ///< number of messages that were sent but never arrived

 private:
  friend AnsweringTopics;

  template <class Bundle, class Answer>
  void serveBundles(ros::NodeHandle& handle, int queue_size, const std::string& in, std::size_t numbers_in,
                    const std::string& out, std::size_t numbers_out);
  template <class Bundle, class Answer>
  bool answer(const Bundle& bundle, Answer& message);
  void countLost(std::uint32_t messages) { lost_ += messages; }
  template <class Answer>
  void countAnswered(const Answer& message, std::int64_t latency);

  const node::ChannelGroup& group_;
  const std::vector<node::ComponentChannel*>& channels_;
  std::atomic<std::uint64_t> answered_{0};
  std::atomic<std::uint64_t> malformed_{0};
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace rubber_suspension::ros_interface
