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

/// Thrown if no node serves the topics, or if the node stops answering or drops a sample.
class BundleError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Sends and receives in the calling thread, with a callback queue of its own. Further messages may be sent before
/// earlier ones are answered.
template <class Bundle, class Sample, class Answer>
class BundleClientOf {
 public:
  static constexpr double kPatience = 30.0;  ///< default timeout [s]

  /// `timeout` [s] bounds every wait.
  BundleClientOf(const ros::NodeHandle& handle, std::vector<std::string> components, double timeout = kPatience);

  /// Waits until both topics are connected. Without this, the first messages could be lost. Throws BundleError.
  void connect();

  /// Calls a service of type std_srvs/Trigger of the node, such as simulate/reset. Throws BundleError.
  void call(const std::string& service);

  /// Sends displacements [m] or poses [m], in the order of the components, with a stamp [ns]. Stamps must increase and
  /// be within the range of a ROS header (0 to 2^32 s).
  void send(std::int64_t stamp, const std::vector<Sample>& samples);

  /// Returns the answer to the message that was sent with this stamp [ns]; answers to earlier messages are discarded.
  /// Throws BundleError if no answer comes in time or the answer lacks a component.
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

/// Sends poses of body B in body A for components of six directions and receives wrenches on B.
using PoseClient = BundleClientOf<PoseArray, geometry_msgs::Pose, WrenchArray>;

}  // namespace rubber_suspension::ros_interface
