// The other end of the bundled topics: a simulation that sends the displacements of all components and takes forces.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/ForceArray.h>

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
class BundleClient {
 public:
  static constexpr double kPatience = 30.0;  ///< [s]

  /// `timeout` [s] bounds every wait.
  BundleClient(const ros::NodeHandle& handle, std::vector<std::string> components, double timeout = kPatience);

  /// Wait until nothing that is sent or answered can be lost. Throws BundleError.
  void connect();

  /// Call a service of type std_srvs/Trigger of the node, such as simulate/reset. Throws BundleError.
  void call(const std::string& service);

  /// Send the displacements [m], in the order of the components, at a stamp [ns]. Stamps have to increase, and to lie
  /// within what a ROS header can hold (0 to 2^32 s).
  void send(std::int64_t stamp, const std::vector<double>& displacement);

  /// Wait for the answer to the message of a stamp that was sent; answers to earlier ones are discarded.
  /// Throws BundleError where it does not come in time, or where not every component has a force in it.
  ForceArray receive(std::int64_t stamp);

 private:
  ros::NodeHandle handle_;
  ros::CallbackQueue queue_;
  double timeout_;
  DisplacementArray message_;
  std::deque<ForceArray> answers_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace rubber_suspension::ros_interface
