// A running node has exactly the topics and services that the table lists.
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

// Returns the names that the master lists for the node: topics published, topics subscribed, or services.
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

// Removes the names that every node of roscpp has.
Names withoutThoseOfAllNodes(Names names) {
  names.erase("/rosout");
  names.erase("/clock");
  names.erase(kNode + "/get_loggers");
  names.erase(kNode + "/set_logger_level");
  return names;
}

// Inserts the name once for each direction in which the bush has a law.
void insertAll(const std::string& name, Names& names) {
  const std::string placeholder = "DIRECTION";
  const std::size_t place = name.find(placeholder);
  if (place == std::string::npos) {
    names.insert(name);
    return;
  }
  for (const char* direction : {"x", "y", "z", "rx"}) {
    names.insert(std::string(name).replace(place, placeholder.size(), direction));
  }
}

Names expected(Kind kind) {
  Names names;
  for (const ros_interface::InterfaceEntry& entry : ros_interface::nodeInterface()) {
    if (entry.kind != kind) {
      continue;
    }
    const std::string placeholder = "COMPONENT";
    if (entry.name.compare(0, placeholder.size(), placeholder) == 0) {
      for (const auto& [component, directions] : {std::pair("left_secondary", 1), std::pair("bush", 6)}) {
        if (entry.directions == 0 || entry.directions == directions) {
          insertAll(std::string("/bench/") + component + entry.name.substr(placeholder.size()), names);
        }
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
