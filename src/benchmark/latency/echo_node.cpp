// A node that answers every displacement at once.
#include "benchmark/latency/echo_node.h"

#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/Force.h>
#include <rubber_suspension/ForceArray.h>

namespace rubber_suspension::benchmark {
namespace {

Force echo(const Displacement& displacement) {
  Force force;
  force.header = displacement.header;
  force.displacement = displacement.displacement;
  return force;
}

ForceArray echo(const DisplacementArray& bundle) {
  ForceArray forces;
  forces.header = bundle.header;
  forces.components = bundle.components;
  forces.displacement = forces.force = forces.elastic = forces.viscous = forces.friction = bundle.displacement;
  return forces;
}

template <class In, class Out>
void connect(ros::NodeHandle& handle, const std::string& in, const std::string& out, std::uint32_t queue_size,
             std::vector<ros::Publisher>& publishers, std::vector<ros::Subscriber>& subscribers) {
  publishers.push_back(handle.advertise<Out>(out, queue_size));
  const boost::function<void(const boost::shared_ptr<const In>&)> answer =
      [publisher = publishers.back()](const boost::shared_ptr<const In>& message) {
        publisher.publish(echo(*message));
      };
  subscribers.push_back(
      handle.subscribe<In>(in, queue_size, answer, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
}

}  // namespace

EchoNode::EchoNode(ros::NodeHandle& handle, const std::vector<std::string>& components, int queue_size) {
  const auto size = static_cast<std::uint32_t>(queue_size);
  for (const std::string& component : components) {
    connect<Displacement, Force>(handle, component + "/displacement", component + "/force", size, publishers_,
                                 subscribers_);
  }
  connect<DisplacementArray, ForceArray>(handle, "displacements", "forces", size, publishers_, subscribers_);
}

}  // namespace rubber_suspension::benchmark
