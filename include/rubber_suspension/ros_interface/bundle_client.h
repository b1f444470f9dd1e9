// Client of the bundled topics, for a simulation that sends the displacements of all components and receives forces.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/ForceArray.h>
#include <rubber_suspension/PoseArray.h>
#include <rubber_suspension/WrenchArray.h>

#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// No node serves the topics, it stopped answering, or it dropped a sample.
class BundleError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Sends and receives in the calling thread, with a callback queue of its own. Several messages may be unanswered.
template <class Bundle, class Sample, class Answer>
class BundleClientOf {
 public:
  static constexpr double kPatience = 30.0;  ///< default timeout [s]

  /// `timeout` [s] bounds every wait.
  BundleClientOf(const ros::NodeHandle& handle, std::vector<std::string> components, double timeout = kPatience);

  /// Waits until both topics are connected, so that no message is lost. Throws BundleError.
  void connect();

  /// Calls a service of type std_srvs/Trigger of the node, such as simulate/reset. Throws BundleError.
  void call(const std::string& service);

  /// Sends the displacements [m] or poses [m], in the order of the components, at a stamp [ns]. Stamps must increase
  /// and lie within the range of a ROS header (0 to 2^32 s).
  void send(std::int64_t stamp, const std::vector<Sample>& samples);

  /// Returns the answer to the message that was sent with this stamp [ns]; answers to earlier messages are discarded.
  /// Throws BundleError if no answer comes in time, or if it lacks a component.
  Answer receive(std::int64_t stamp);

 private:
  ros::NodeHandle handle_;
  ros::CallbackQueue queue_;
  double timeout_;
  Bundle message_;
  std::deque<Answer> answers_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

/// Sends displacements of components of one direction and receives forces.
using BundleClient = BundleClientOf<DisplacementArray, double, ForceArray>;

/// Sends poses of B in A, of components of six directions, and receives wrenches on B.
using PoseClient = BundleClientOf<PoseArray, geometry_msgs::Pose, WrenchArray>;

}  // namespace rubber_suspension::ros_interface
