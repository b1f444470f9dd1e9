// A test bench that sends displacements to the node, waits for each force, and reads the node's diagnostics.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/Force.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "bag/header_stamp.h"
#include "ros_interface/connection.h"

namespace rubber_suspension {

/// Time [s] after which a wait fails. It is long, so that no test depends on the speed of the computer.
constexpr double kPatience = 30.0;

/// Calls the callbacks of ROS until `done` returns true. Returns false if the time limit is reached first.
template <class Condition>
bool spinUntil(Condition done, double patience = kPatience) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
  while (!done()) {
    if (std::chrono::steady_clock::now() > end || !ros::ok()) {
      return false;
    }
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
  return true;
}

/// A component, as the driver of its rig sees it through topics.
class Bench {
 public:
  explicit Bench(const std::string& component) : component_(component) {
    publisher_ = handle_.advertise<Displacement>(component + "/displacement", 100000);
    subscriber_ = handle_.subscribe<Force>(component + "/force", 100000,
                                           [this](const Force::ConstPtr& force) { forces.push_back(*force); });
  }

  /// Waits until connections in both directions exist, so that no message is lost.
  bool connect() {
    return ros_interface::waitForPublishers(subscriber_.getTopic(), kPatience) &&
           spinUntil([this] { return publisher_.getNumSubscribers() > 0; });
  }

  bool isHeard() const { return publisher_.getNumSubscribers() > 0; }

  void send(std::int64_t stamp, double displacement) {
    Displacement message;
    message.header.stamp = bag::toRosTime(stamp);
    message.header.frame_id = "bench";
    message.displacement = displacement;
    publisher_.publish(message);
  }

  /// Sends a sample and returns its force. All earlier samples must have been answered.
  Force ask(std::int64_t stamp, double displacement) {
    const std::size_t before = forces.size();
    send(stamp, displacement);
    if (!spinUntil([&] { return forces.size() > before; })) {
      ADD_FAILURE() << component_ << ": no force for stamp " << stamp;
      return Force();
    }
    return forces.back();
  }

  /// Waits until this many forces have arrived in total, and returns false if the time limit is reached first.
  bool waitForForces(std::size_t count) {
    return spinUntil([&] { return forces.size() >= count; });
  }

  std::vector<Force> forces;  ///< all that arrived, in order

 private:
  std::string component_;
  ros::NodeHandle handle_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

/// Stores the newest diagnostics of every component.
class DiagnosticsWatch {
 public:
  DiagnosticsWatch() {
    subscriber_ = handle_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 100, [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& array) { take(*array); });
  }

  /// Returns the value of a key, or an empty string before the first diagnostics of the component.
  std::string value(const std::string& component, const std::string& key) const {
    const auto status = status_.find(component);
    if (status != status_.end()) {
      for (const auto& entry : status->second.values) {
        if (entry.key == key) {
          return entry.value;
        }
      }
    }
    return {};
  }

  long count(const std::string& component, const std::string& key) const {
    return std::strtol(value(component, key).c_str(), nullptr, 10);
  }

  /// Waits until the counter has the expected value, because counters are published only once per second.
  bool waitForCount(const std::string& component, const std::string& key, long expected) {
    const bool reached = spinUntil([&] { return !value(component, key).empty() && count(component, key) == expected; });
    if (!reached) {
      ADD_FAILURE() << component << ": " << key << " is '" << value(component, key) << "', not " << expected;
    }
    return reached;
  }

  /// Returns the latest status of each component, by name.
  const std::map<std::string, diagnostic_msgs::DiagnosticStatus>& all() const { return status_; }

  std::size_t arrays = 0;  ///< number of messages so far

 private:
  void take(const diagnostic_msgs::DiagnosticArray& array) {
    ++arrays;
    for (const auto& status : array.status) {
      if (!status.values.empty()) {  // the announcement at the start of the node has no values
        status_[status.name.substr(status.name.find(": ") + 2)] = status;
      }
    }
  }

  ros::NodeHandle handle_;
  ros::Subscriber subscriber_;
  std::map<std::string, diagnostic_msgs::DiagnosticStatus> status_;
};

/// The stamps of the tests begin here [ns], because stamps from a clock are as large.
constexpr std::int64_t kStart = 1700000000LL * 1000000000LL;
constexpr std::int64_t kMillisecond = 1000000LL;

/// Runs all tests of a rostest program as a ROS node.
inline int runAsNode(int argc, char** argv, const std::string& name) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, name);
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}

}  // namespace rubber_suspension
