// Functions that are shared by the commands that communicate with a running node.
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "command_line/command.h"
#include "element/refuse.h"
#include "ros_interface/connection.h"
#include "ros_interface/log_player.h"
#include "ros_interface/process_fixes.h"

namespace rubber_suspension::apps {

/// Restricts the client to the loopback interface, as the node does. Prints a note if that is not possible.
inline void noteOpenness(const std::string& command) {
  const std::string refusal = ros_interface::keepSlaveApiToLoopback();
  if (!refusal.empty()) {
    command_line::printNote(command, refusal);
  }
}

/// Calls the service that resets the component, unless its name is empty. Throws PlayError.
inline void resetComponent(const ros::NodeHandle& handle, const std::string& service) {
  constexpr double kPatience = 30.0;  // [s]; a node advertises its services after its topics
  const std::string refusal = service.empty() ? "" : ros_interface::callTrigger(handle.resolveName(service), kPatience);
  element::refuseIf<ros_interface::PlayError>(!refusal.empty(), "{}", refusal);
}

/// Returns `play` with a function that prints what the player is waiting for.
inline ros_interface::PlayOptions withNotes(ros_interface::PlayOptions play, const std::string& command) {
  play.notify = [command](const std::string& text) { command_line::printNote(command, text); };
  return play;
}

/// Returns the options of a player. `partner` is the name of the program that returns the forces.
inline command_line::OptionTable playerTable(ros_interface::PlayOptions& play, const std::string& partner) {
  using command_line::Option;
  return {Option("--playback-speed", play.rate, "FACTOR",
                 "playback speed as a multiple of the log's own speed; 0: as fast as the " + partner + " answers")
              .within(0, 1e6),
          Option("--in-flight", play.in_flight, "COUNT", "largest number of samples that are sent but not yet answered")
              .rare()
              .within(1, 100000),
          Option("--timeout", play.answer_timeout, "SECONDS", "time to wait for an answer").rare().within(0.01, 1e6),
          Option("--connect-timeout", play.connect_timeout, "SECONDS", "time to wait for the " + partner)
              .rare()
              .within(0.01, 1e6)};
}

}  // namespace rubber_suspension::apps
