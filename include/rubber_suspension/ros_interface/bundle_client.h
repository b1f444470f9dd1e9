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

/// Sends and receives in the calling thread, with a callback queue of its own. Several messages may be under way.
template <class Bundle, class Sample, class Answer>
class BundleClientOf {
 public:
  static constexpr double kPatience = 30.0;  ///< [s]

  /// `timeout` [s] bounds every wait.
  BundleClientOf(const ros::NodeHandle& handle, std::vector<std::string> components, double timeout = kPatience);

  /// Waits until nothing that is sent or answered can be lost. Throws BundleError.
  void connect();

  /// Calls a service of type std_srvs/Trigger of the node, such as simulate/reset. Throws BundleError.
  void call(const std::string& service);

  /// Sends the displacements [m] or poses [m], in the order of the components, at a stamp [ns]. Stamps have to
  /// increase, and to lie within what a ROS header can hold (0 to 2^32 s).
  void send(std::int64_t stamp, const std::vector<Sample>& samples);

  /// Waits for the answer to the message of a stamp that was sent; answers to earlier ones are discarded.
  /// Throws BundleError where it does not come in time, or where not every component has an answer in it.
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

/// Displacements to forces.
using BundleClient = BundleClientOf<DisplacementArray, double, ForceArray>;

/// Poses of B in A to wrenches on B, of components of six directions.
using PoseClient = BundleClientOf<PoseArray, geometry_msgs::Pose, WrenchArray>;

}  // namespace rubber_suspension::ros_interface
