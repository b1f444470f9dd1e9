// Starts the nodes that a benchmark measures.
#include "benchmark/latency/benchmark_node.h"

#include <fmt/format.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/Force.h>
#include <rubber_suspension/ForceArray.h>

namespace rubber_suspension::benchmark {
namespace {

std::string spaceOf(NodeKind kind) {
  return kind == NodeKind::echo ? "echo" : kind == NodeKind::plain ? "plain" : "diagnosing";
}

std::vector<std::string> commandOf(NodeKind kind, int components, const std::string& config) {
  const std::string space = "__ns:=/" + spaceOf(kind);
  if (kind == NodeKind::echo) {
    return {ros_interface::siblingProgram("benchmark_latency"), "--echo", std::to_string(components), space};
  }
  return {ros_interface::siblingProgram("simulate"), space, "_config_file:=" + config,
          fmt::format("_diagnose:={}", kind == NodeKind::diagnosing)};
}

Force answerTo(const Displacement& displacement) {
  Force force;
  force.header = displacement.header;
  force.displacement = displacement.displacement;
  return force;
}

ForceArray answerTo(const DisplacementArray& bundle) {
  ForceArray forces;
  forces.header = bundle.header;
  forces.components = bundle.components;
  forces.displacement = forces.force = forces.elastic = forces.viscous = forces.friction = bundle.displacement;
  return forces;
}

template <class In, class Out>
ros::Subscriber connect(ros::NodeHandle& handle, const std::string& in, const std::string& out) {
  constexpr std::uint32_t kQueueSize = 10000;  // the same as in the node
  const boost::function<void(const boost::shared_ptr<const In>&)> answer =
      [publisher = handle.advertise<Out>(out, kQueueSize)](const boost::shared_ptr<const In>& message) {
        publisher.publish(answerTo(*message));
      };
  return handle.subscribe<In>(in, kQueueSize, answer, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

}  // namespace

std::vector<std::string> benchmarkNames(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) {
    names.push_back(fmt::format("component_{:03d}", i));
  }
  return names;
}

std::string benchmarkComponents(int count) {
  std::string text = "components:\n";
  int i = 0;
  for (const std::string& name : benchmarkNames(count)) {
    const bool berg = i++ % 2 == 1;
    text += fmt::format(
        "  {}:\n    model: {}\n    specification: {{static_stiffness: 3.0e6, dynamic_stiffness: 4.2e6, "
        "nominal_frequency: 4.0, {}}}\n",
        name, berg ? "berg" : "multi_maxwell",
        berg ? "nominal_amplitude: 0.002, loss_angle: 0.0995, break_frequency: 1.45"
             : "maximum_stiffness: 4.9e6, high_frequency: 25.0");
  }
  return text;
}

std::vector<ros::Subscriber> echo(ros::NodeHandle& handle, const std::vector<std::string>& components) {
  std::vector<ros::Subscriber> subscribers = {
      connect<DisplacementArray, ForceArray>(handle, "displacements", "forces")};
  for (const std::string& component : components) {
    subscribers.push_back(connect<Displacement, Force>(handle, component + "/displacement", component + "/force"));
  }
  return subscribers;
}

BenchmarkNode::BenchmarkNode(NodeKind kind, int components, bool bundled, bool measured)
    : file_(spaceOf(kind) + ".yaml", benchmarkComponents(components)),
      process_(commandOf(kind, components, file_.path())),
      meter_("/" + spaceOf(kind), benchmarkNames(components), bundled, measured) {}

}  // namespace rubber_suspension::benchmark
