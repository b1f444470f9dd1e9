// What commands that speak to a running node share.
#pragma once

#include <fmt/format.h>
#include <ros/node_handle.h>
#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include <iostream>
#include <string>

#include "command_line/option_table.h"
#include "ros_interface/log_player.h"
#include "ros_interface/loopback.h"

namespace rubber_suspension::apps {

/// A node that is kept to the loopback interface gets a client that is; where that is refused, say so.
inline void noteOpenness(const std::string& command) {
  const std::string refusal = ros_interface::keepSlaveApiToLoopback();
  if (!refusal.empty()) {
    std::cerr << command << ": note: " << refusal << '\n';
  }
}

/// Call a service that makes the component new, unless its name is empty. Throws PlayError.
inline void resetComponent(const ros::NodeHandle& handle, const std::string& service) {
  std_srvs::Trigger trigger;
  if (!service.empty() && (!ros::service::call(handle.resolveName(service), trigger) || !trigger.response.success)) {
    throw ros_interface::PlayError(fmt::format("service {} failed {}", service, trigger.response.message));
  }
}

/// The options of a player; the partner is who answers it.
inline command_line::OptionTable playerTable(ros_interface::PlayOptions& play, const std::string& partner) {
  using command_line::Option;
  return {
      Option("--playback-speed", play.rate, "FACTOR",
             "multiple of the log's own speed; 0: as fast as the " + partner + " answers")
          .within(0, 1e6),
      Option("--in-flight", play.in_flight, "COUNT", "samples sent and not yet answered, at most").within(1, 100000),
      Option("--timeout", play.answer_timeout, "SECONDS", "time to wait for an answer").within(0.01, 1e6),
      Option("--connect-timeout", play.connect_timeout, "SECONDS", "time to wait for the " + partner)
          .within(0.01, 1e6)};
}

}  // namespace rubber_suspension::apps
