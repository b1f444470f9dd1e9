// Topics, services and parameters of the node `simulate`, in one table.
#include "ros_interface/node_interface.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <fmt/format.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <rubber_suspension/Diagnosis.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/EnableComponent.h>
#include <rubber_suspension/Force.h>
#include <rubber_suspension/ForceArray.h>
#include <rubber_suspension/Gap.h>
#include <rubber_suspension/GapShare.h>
#include <rubber_suspension/MeasuredForce.h>
#include <rubber_suspension/PoseArray.h>
#include <rubber_suspension/ResetComponent.h>
#include <rubber_suspension/Running.h>
#include <rubber_suspension/WrenchArray.h>
#include <sensor_msgs/Temperature.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "ros_interface/child_process.h"
#include "ros_interface/node_settings.h"

namespace rubber_suspension::ros_interface {
namespace {

using Kind = InterfaceEntry::Kind;

template <class Message>
InterfaceEntry topic(const std::string& name, Kind kind, const std::string& documentation, int directions = 0) {
  return {name, ros::message_traits::DataType<Message>::value(), kind, documentation, directions};
}

template <class Service>
InterfaceEntry service(const std::string& name, const std::string& documentation, int directions = 0) {
  return {name, ros::service_traits::DataType<Service>::value(), Kind::service, documentation, directions};
}

std::string table(bool services) {
  std::string text =
      services ? "| service | type | |\n|---|---|---|\n" : "| topic | direction | type | |\n|---|---|---|---|\n";
  for (const InterfaceEntry& entry : nodeInterface()) {
    if ((entry.kind == Kind::service) == services) {
      text += fmt::format("| `{}` | {}`{}` | {} |\n", entry.name,
                          services                         ? ""
                          : entry.kind == Kind::subscribed ? "in | "
                                                           : "out | ",
                          entry.type, entry.documentation);
    }
  }
  return text;
}

// The text of the .msg file itself; what follows a line of equals signs are the messages that it contains.
template <class Message>
std::string definition() {
  std::string text = ros::message_traits::Definition<Message>::value();
  text = text.substr(0, text.find("\n====="));
  while (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  return fmt::format("\n### {}\n\n```\n{}\n```\n", ros::message_traits::DataType<Message>::value(), text);
}

}  // namespace

const std::vector<InterfaceEntry>& nodeInterface() {
  static const std::vector<InterfaceEntry> table = {
      topic<Displacement>("COMPONENT/displacement", Kind::subscribed, "each accepted sample is answered by one force",
                          1),
      topic<Force>("COMPONENT/force", Kind::published, "the answer, with the header of the displacement", 1),
      topic<MeasuredForce>("COMPONENT/measured_force", Kind::subscribed,
                           "optional: with the force of the real component the node watches the gap", 1),
      topic<sensor_msgs::Temperature>("COMPONENT/temperature", Kind::subscribed,
                                      "optional [degC]: holds for the samples from its stamp on, where the component "
                                      "has the key `temperature`"),
      topic<Gap>("COMPONENT/gap", Kind::published, "once per second, with a measured force: level, where and trend", 1),
      topic<Gap>("COMPONENT/shadow_gap", Kind::published,
                 "the same for the model that is computed beside the one that gives the force, while there is one", 1),
      topic<Running>("COMPONENT/running", Kind::published,
                     "latched: whether the configured or a promoted model gives the force, and its hash"),
      topic<Diagnosis>("COMPONENT/diagnosis", Kind::published,
                       "latched: where ~diagnose is true, which effect the model lacks, since when, and how sure that "
                       "is",
                       1),
      topic<geometry_msgs::PoseStamped>("COMPONENT/pose", Kind::subscribed,
                                        "of six directions, in place of displacement: body B in body A, whose frame is "
                                        "that of the header; each accepted sample is answered by one wrench",
                                        6),
      topic<geometry_msgs::WrenchStamped>("COMPONENT/wrench", Kind::published,
                                          "the answer, with the header of the pose: what has to be applied to B, at "
                                          "B's origin, to hold the pose, in A's axes",
                                          6),
      topic<geometry_msgs::WrenchStamped>("COMPONENT/measured_wrench", Kind::subscribed,
                                          "optional: with the wrench of the real component, likewise, the node watches "
                                          "the gap of each direction",
                                          6),
      topic<Gap>("COMPONENT/DIRECTION/gap", Kind::published,
                 "of six directions: the gap of each that is not free, x to rz, along and about the axes of the "
                 "component",
                 6),
      topic<PoseArray>("poses", Kind::subscribed, "all components of six directions in one message"),
      topic<WrenchArray>("wrenches", Kind::published, "the answer to it"),
      topic<DisplacementArray>("displacements", Kind::subscribed, "all components of one direction in one message"),
      topic<ForceArray>("forces", Kind::published, "the answer to it"),
      topic<diagnostic_msgs::DiagnosticArray>("/diagnostics", Kind::published,
                                              "once per second: rate, drops, rejects, latency and gap per component"),
      service<std_srvs::Trigger>("~reset", "reset all components: at rest, as new"),
      service<std_srvs::Trigger>("~save_state", "write the state of all components to ~state_file"),
      service<std_srvs::Trigger>("~load_state", "continue from the state in ~state_file"),
      service<std_srvs::Trigger>("~reload", "read the component file again; unchanged components keep their state"),
      service<std_srvs::SetBool>("~set_enabled", "a disabled component answers no displacement and keeps its state"),
      service<ResetComponent>("~reset_component", "reset the one of the name `component`: at rest, as new"),
      service<EnableComponent>("~enable_component", "as ~set_enabled, for the one of the name `component`"),
      service<std_srvs::Trigger>(
          "COMPONENT/promote",
          "where ~diagnose or ~promote_file is set: put the model of ~promote_file in the place "
          "of the configured one, or the one that the live diagnosis found: first in its shadow, "
          "then by a cross-fade",
          1),
      service<std_srvs::Trigger>("COMPONENT/rollback",
                                 "likewise, or where a state with a promoted model was loaded: back to the configured "
                                 "model, by a cross-fade",
                                 1),
  };
  return table;
}

std::string topicReference() {
  std::string text =
      "# Reference of the node `simulate`\n\n"
      "Written by the command `reference` from a table; a test compares it with a running node. `COMPONENT` stands "
      "for\n"
      "the name of each component, `DIRECTION` for each of its directions that is not free, `~` for the name of the "
      "node.\n\n"
      "## Topics\n\n" +
      table(false) + "\n## Services\n\n" + table(true) + "\n## Private parameters\n\n```\n" + describeNodeSettings() +
      "```\n\n## Messages\n";
  text += definition<Displacement>() + definition<Force>() + definition<MeasuredForce>() + definition<Gap>() +
          definition<GapShare>() + definition<Running>() + definition<Diagnosis>() + definition<DisplacementArray>() +
          definition<ForceArray>() + definition<PoseArray>() + definition<WrenchArray>();
  return text;
}

}  // namespace rubber_suspension::ros_interface
