// The node as the partner of a vehicle that steps at fixed times: the bundled topics.
#pragma once

#include <string>

#include "rubber_suspension/ros_interface/bundle_client.h"
#include "vehicle/force_exchange.h"

namespace rubber_suspension::vehicle {

constexpr std::int64_t kFirstStamp = 1000000000;  ///< [ns]; 0 stands for "no stamp" in many a tool

class TopicExchange final : public ForceExchange {
 public:
  /// Waits for the node, and calls its service `reset` unless that is empty. Throws BundleError.
  TopicExchange(const ros::NodeHandle& handle, const std::string& reset)
      : client_(handle, {strutNames().begin(), strutNames().end()}) {
    client_.connect();
    if (!reset.empty()) {
      client_.call(reset);
    }
  }

  void send(std::int64_t stamp, const PerStrut& displacement) override {
    client_.send(stamp + kFirstStamp, {displacement.begin(), displacement.end()});
  }

  PerStrut receive(std::int64_t stamp) override {
    const ForceArray answer = client_.receive(stamp + kFirstStamp);
    return {answer.force[0], answer.force[1], answer.force[2]};
  }

 private:
  ros_interface::BundleClient client_;
};

/// The same with components of six directions.
class TopicWrenchExchange final : public WrenchExchange {
 public:
  TopicWrenchExchange(const ros::NodeHandle& handle, BushedKind kind, const std::string& reset)
      : client_(handle, bushNames(kind)) {
    client_.connect();
    if (!reset.empty()) {
      client_.call(reset);
    }
  }

  void send(std::int64_t stamp, const PerBush<Eigen::Isometry3d>& motions) override {
    std::vector<geometry_msgs::Pose> poses;
    for (const Eigen::Isometry3d& motion : motions) {
      const Eigen::Quaterniond rotation(motion.linear());
      geometry_msgs::Pose pose;
      pose.position.x = motion.translation().x();
      pose.position.y = motion.translation().y();
      pose.position.z = motion.translation().z();
      pose.orientation.w = rotation.w();
      pose.orientation.x = rotation.x();
      pose.orientation.y = rotation.y();
      pose.orientation.z = rotation.z();
      poses.push_back(pose);
    }
    client_.send(stamp + kFirstStamp, poses);
  }

  PerBush<component::Wrench> receive(std::int64_t stamp) override {
    PerBush<component::Wrench> wrenches;
    for (const geometry_msgs::Wrench& wrench : client_.receive(stamp + kFirstStamp).wrenches) {
      wrenches.push_back(
          {{wrench.force.x, wrench.force.y, wrench.force.z}, {wrench.torque.x, wrench.torque.y, wrench.torque.z}});
    }
    return wrenches;
  }

 private:
  ros_interface::PoseClient client_;
};

}  // namespace rubber_suspension::vehicle
