// A node that answers every displacement at once: the floor that the transport sets to any node's latency.
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

namespace rubber_suspension::benchmark {

/// Same topics and messages as the node `simulate`, single and bundled, but no component behind them.
class EchoNode {
 public:
  EchoNode(ros::NodeHandle& handle, const std::vector<std::string>& components, int queue_size);

 private:
  std::vector<ros::Publisher> publishers_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace rubber_suspension::benchmark
