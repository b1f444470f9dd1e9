// The node as the partner of a vehicle that steps at fixed times: the bundled topics.
#pragma once

#include <string>
#include <vector>

#include "ros_interface/pose_messages.h"
#include "rubber_suspension/ros_interface/bundle_client.h"
#include "vehicle/force_exchange.h"

namespace rubber_suspension::vehicle {

constexpr std::int64_t kFirstStamp = 1000000000;  ///< [ns]; 0 stands for "no stamp" in many a tool

inline std::vector<double> samplesOf(const PerStrut& displacement) {
  return {displacement.begin(), displacement.end()};
}

inline std::vector<geometry_msgs::Pose> samplesOf(const PerBush<Eigen::Isometry3d>& motions) {
  std::vector<geometry_msgs::Pose> poses;
  for (const Eigen::Isometry3d& motion : motions) {
    poses.push_back(ros_interface::messageOf(motion.translation(), Eigen::Quaterniond(motion.linear())));
  }
  return poses;
}

inline PerStrut loadsOf(const ForceArray& answer) { return {answer.force[0], answer.force[1], answer.force[2]}; }

inline PerBush<component::Wrench> loadsOf(const WrenchArray& answer) {
  PerBush<component::Wrench> wrenches;
  for (const geometry_msgs::Wrench& wrench : answer.wrenches) {
    wrenches.push_back(ros_interface::wrenchOf(wrench));
  }
  return wrenches;
}

template <class Client, class Motions, class Loads>
class ClientExchange final : public Exchange<Motions, Loads> {
 public:
  /// Waits for the node that serves these components, and calls its service `reset` unless that is empty. Throws
  /// BundleError.
  ClientExchange(const ros::NodeHandle& handle, const std::vector<std::string>& components, const std::string& reset)
      : client_(handle, components) {
    client_.connect();
    if (!reset.empty()) {
      client_.call(reset);
    }
  }

  void send(std::int64_t stamp, const Motions& motions) override {
    client_.send(stamp + kFirstStamp, samplesOf(motions));
  }
  Loads receive(std::int64_t stamp) override { return loadsOf(client_.receive(stamp + kFirstStamp)); }

 private:
  Client client_;
};

using TopicExchange = ClientExchange<ros_interface::BundleClient, PerStrut, PerStrut>;

/// The same with components of six directions.
using TopicWrenchExchange =
    ClientExchange<ros_interface::PoseClient, PerBush<Eigen::Isometry3d>, PerBush<component::Wrench>>;

}  // namespace rubber_suspension::vehicle
