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

// Returns the text of the .msg file, without the definitions of contained messages, which follow a line of "=".
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
                           "optional: measured force, with which the node monitors the gap", 1),
      topic<sensor_msgs::Temperature>(
          "COMPONENT/temperature", Kind::subscribed,
          "optional, for components with the key `temperature`: temperature [degC], valid from its stamp on"),
      topic<Gap>("COMPONENT/gap", Kind::published,
                 "once per second if a force is measured: level, place and trend of the gap", 1),
      topic<Gap>("COMPONENT/shadow_gap", Kind::published,
                 "gap of a second model, whose force is computed but not published (see COMPONENT/promote)", 1),
      topic<Running>("COMPONENT/running", Kind::published,
                     "latched: whether the configured or a promoted model gives the force, and the hash of this model"),
      topic<Diagnosis>(
          "COMPONENT/diagnosis", Kind::published,
          "latched, if ~diagnose is true: which effect the model lacks, since when, and how certain this is", 1),
      topic<geometry_msgs::PoseStamped>("COMPONENT/pose", Kind::subscribed,
                                        "for six directions, instead of displacement: pose of body B in body A, whose "
                                        "frame is that of the header; each accepted sample is answered by one wrench",
                                        6),
      topic<geometry_msgs::WrenchStamped>("COMPONENT/wrench", Kind::published,
                                          "the answer, with the header of the pose: the wrench that must be applied to "
                                          "B, at B's origin, to hold the pose, in A's axes",
                                          6),
      topic<geometry_msgs::WrenchStamped>(
          "COMPONENT/measured_wrench", Kind::subscribed,
          "optional: measured wrench, with which the node monitors the gap of each direction", 6),
      topic<Gap>("COMPONENT/DIRECTION/gap", Kind::published,
                 "for six directions: gap of each direction (x to rz) that is not free, along or about the axes of the "
                 "component",
                 6),
      topic<PoseArray>("poses", Kind::subscribed, "all components of six directions in one message"),
      topic<WrenchArray>("wrenches", Kind::published, "the answer to a message on poses"),
      topic<DisplacementArray>("displacements", Kind::subscribed, "all components of one direction in one message"),
      topic<ForceArray>("forces", Kind::published, "the answer to a message on displacements"),
      topic<diagnostic_msgs::DiagnosticArray>(
          "/diagnostics", Kind::published, "once per second: rate, dropped samples, latency and gap of each component"),
      service<std_srvs::Trigger>("~reset", "reset all components to rest, as new"),
      service<std_srvs::Trigger>("~save_state", "write the state of all components to ~state_file"),
      service<std_srvs::Trigger>("~load_state", "continue from the state in ~state_file"),
      service<std_srvs::Trigger>("~reload", "read the component file again; unchanged components keep their state"),
      service<std_srvs::SetBool>(
          "~set_enabled", "enable or disable all components; a disabled component does not answer and keeps its state"),
      service<ResetComponent>("~reset_component", "reset the component with the name `component` to rest, as new"),
      service<EnableComponent>("~enable_component", "like ~set_enabled, for the component with the name `component`"),
      service<std_srvs::Trigger>(
          "COMPONENT/promote",
          "if ~diagnose or ~promote_file is set: replace the configured model with the model of ~promote_file or of "
          "the live diagnosis, which first runs in parallel (shadow), then takes over in a cross-fade",
          1),
      service<std_srvs::Trigger>("COMPONENT/rollback",
                                 "if ~diagnose or ~promote_file is set or a loaded state has a promoted model: return "
                                 "to the configured model with a cross-fade",
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
