// Exchanges the displacements and forces of a vehicle with the node over the bundled topics, at fixed time steps.
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "ros_interface/pose_messages.h"
#include "rubber_suspension/ros_interface/bundle_client.h"
#include "vehicle/simulation.h"

namespace rubber_suspension::vehicle {

/// Base class of the exchange over both kinds of bundles. The constructor waits for the node and calls its service
/// `reset`, unless the name of the service is empty. Throws BundleError.
template <class Client>
class TopicExchange : public Exchange {
 public:
  TopicExchange(Kind kind, const std::string& reset) : client_(ros::NodeHandle(), bushNames(kind)) {
    client_.connect();
    if (!reset.empty()) {
      client_.call(reset);
    }
  }

 protected:
  static constexpr std::int64_t kFirstStamp = 1000000000;  // [ns]; not 0, which many tools interpret as "no stamp"

  Client client_;
};

/// Exchanges poses and wrenches of components with six directions.
class PoseExchange final : public TopicExchange<ros_interface::PoseClient> {
 public:
  using TopicExchange::TopicExchange;

  void send(std::int64_t stamp, const Poses& poses) override {
    std::vector<geometry_msgs::Pose> messages;
    for (const Eigen::Isometry3d& pose : poses) {
      messages.push_back(ros_interface::messageOf(pose.translation(), Eigen::Quaterniond(pose.linear())));
    }
    client_.send(stamp + kFirstStamp, messages);
  }

  Wrenches receive(std::int64_t stamp) override {
    Wrenches wrenches;
    for (const geometry_msgs::Wrench& wrench : client_.receive(stamp + kFirstStamp).wrenches) {
      wrenches.push_back(ros_interface::wrenchOf(wrench));
    }
    return wrenches;
  }
};

/// Exchanges displacements and forces of struts along their z axes.
class StrutExchange final : public TopicExchange<ros_interface::BundleClient> {
 public:
  /// The struts must outlive this object.
  StrutExchange(const Bushes& struts, const std::string& reset) : TopicExchange(Kind::struts, reset), struts_(struts) {}

  void send(std::int64_t stamp, const Poses& poses) override {
    std::vector<double> displacements;
    sent_.emplace_back(stamp, Poses());
    for (std::size_t i = 0; i < struts_.size(); ++i) {
      // Converts to a quaternion and back, with the same rounding as for a component in this process.
      const auto pose = component::poseOf(poses[i].translation(), Eigen::Quaterniond(poses[i].linear()));
      displacements.push_back(struts_[i].coordinates(pose)[component::kZ]);
      sent_.back().second.push_back(pose);
    }
    client_.send(stamp + kFirstStamp, displacements);
  }

  Wrenches receive(std::int64_t stamp) override {
    const ForceArray answer = client_.receive(stamp + kFirstStamp);
    while (sent_.front().first < stamp) {
      sent_.pop_front();
    }
    Wrenches wrenches;
    for (std::size_t i = 0; i < struts_.size(); ++i) {
      const component::SixDirectionsLaws& laws = struts_[i].laws();
      const Eigen::Vector3d force = laws.on_a.linear() * Eigen::Vector3d(0.0, 0.0, answer.force[i]);
      const Eigen::Vector3d arm = sent_.front().second[i].linear() * laws.on_b.translation();
      wrenches.push_back({force, arm.cross(force)});
    }
    return wrenches;
  }

 private:
  const Bushes& struts_;
  std::deque<std::pair<std::int64_t, Poses>> sent_;
};

}  // namespace rubber_suspension::vehicle
