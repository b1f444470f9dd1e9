// A node that answers every displacement at once.
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/Force.h>
#include <rubber_suspension/ForceArray.h>

#include "benchmark/latency/benchmark_node.h"

namespace rubber_suspension::benchmark {
namespace {

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
  constexpr std::uint32_t kQueueSize = 10000;  // that of the node
  const boost::function<void(const boost::shared_ptr<const In>&)> answer =
      [publisher = handle.advertise<Out>(out, kQueueSize)](const boost::shared_ptr<const In>& message) {
        publisher.publish(answerTo(*message));
      };
  return handle.subscribe<In>(in, kQueueSize, answer, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

}  // namespace

std::vector<ros::Subscriber> echo(ros::NodeHandle& handle, const std::vector<std::string>& components) {
  std::vector<ros::Subscriber> subscribers = {
      connect<DisplacementArray, ForceArray>(handle, "displacements", "forces")};
  for (const std::string& component : components) {
    subscribers.push_back(connect<Displacement, Force>(handle, component + "/displacement", component + "/force"));
  }
  return subscribers;
}

}  // namespace rubber_suspension::benchmark
