// The node as the partner of a vehicle that steps at fixed times: the bundled topics.
#pragma once

#include <string>

#include "rubber_suspension/ros_interface/bundle_client.h"
#include "vehicle/force_exchange.h"

namespace rubber_suspension::vehicle {

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
  static constexpr std::int64_t kFirstStamp = 1000000000;  // [ns]; 0 stands for "no stamp" in many a tool

  ros_interface::BundleClient client_;
};

}  // namespace rubber_suspension::vehicle
