// The table of the node's topics and services is what a running node has: nothing more, nothing less.
#include <ros/master.h>
#include <ros/service.h>

#include <set>

#include "bench.h"
#include "ros_interface/node_interface.h"

namespace rubber_suspension {
namespace {

using Kind = ros_interface::InterfaceEntry::Kind;
using Names = std::set<std::string>;

const std::string kNode = "/bench/simulate";

// What the master knows of the node: topics published, topics subscribed, services.
Names ofNode(int list) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue state;
  request[0] = ros::this_node::getName();
  Names names;
  if (!ros::master::execute("getSystemState", request, response, state, false)) {
    return names;
  }
  for (int i = 0; i < state[list].size(); ++i) {
    for (int j = 0; j < state[list][i][1].size(); ++j) {
      if (static_cast<std::string>(state[list][i][1][j]) == kNode) {
        names.insert(static_cast<std::string>(state[list][i][0]));
      }
    }
  }
  return names;
}

// Every node of roscpp has these.
Names withoutThoseOfAllNodes(Names names) {
  names.erase("/rosout");
  names.erase("/clock");
  names.erase(kNode + "/get_loggers");
  names.erase(kNode + "/set_logger_level");
  return names;
}

Names expected(Kind kind) {
  Names names;
  for (const ros_interface::InterfaceEntry& entry : ros_interface::nodeInterface()) {
    if (entry.kind != kind) {
      continue;
    }
    const std::string placeholder = "COMPONENT";
    if (entry.name.compare(0, placeholder.size(), placeholder) == 0) {
      for (const std::string component : {"left_secondary", "right_secondary"}) {
        names.insert("/bench/" + component + entry.name.substr(placeholder.size()));
      }
    } else if (entry.name[0] == '~') {
      names.insert(kNode + "/" + entry.name.substr(1));
    } else {
      names.insert(entry.name[0] == '/' ? entry.name : "/bench/" + entry.name);
    }
  }
  return names;
}

void expectTable(Kind kind, int list) {
  spinUntil([&] { return withoutThoseOfAllNodes(ofNode(list)) == expected(kind); });
  EXPECT_EQ(withoutThoseOfAllNodes(ofNode(list)), expected(kind));
}

TEST(NodeInterface, PublishesTheTopicsOfTheTable) { expectTable(Kind::published, 0); }
TEST(NodeInterface, SubscribesToTheTopicsOfTheTable) { expectTable(Kind::subscribed, 1); }
TEST(NodeInterface, HasTheServicesOfTheTable) { expectTable(Kind::service, 2); }

TEST(NodeInterface, TopicsHaveTheTypesOfTheTable) {
  ros::master::V_TopicInfo topics;
  ASSERT_TRUE(ros::master::getTopics(topics));
  int found = 0;
  for (const ros::master::TopicInfo& topic : topics) {
    for (const ros_interface::InterfaceEntry& entry : ros_interface::nodeInterface()) {
      const std::string end = entry.name.substr(entry.name.find('/') == std::string::npos ? 0 : entry.name.find('/'));
      const std::string full = end[0] == '/' ? end : "/" + end;
      const bool same = entry.kind == Kind::published && topic.name.size() >= full.size() &&
                        topic.name.compare(topic.name.size() - full.size(), full.size(), full) == 0;
      if (same) {
        ++found;
        EXPECT_EQ(topic.datatype, entry.type) << topic.name;
      }
    }
  }
  EXPECT_GE(found, 5);
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "interface"); }
