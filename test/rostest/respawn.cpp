// The node is killed in mid-run and respawned: it serves again, from a new specimen, and counts anew.
#include <ros/network.h>
#include <signal.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include "bench.h"

namespace rubber_suspension {
namespace {

// The process of a node, by its slave API; 0 where it does not answer.
pid_t processOf(const std::string& node) {
  XmlRpc::XmlRpcValue arguments;
  arguments[0] = ros::this_node::getName();
  arguments[1] = node;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", arguments, response, uri, false) ||
      !ros::network::splitURI(static_cast<std::string&>(uri), host, port)) {
    return 0;
  }
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue caller;
  caller[0] = ros::this_node::getName();
  XmlRpc::XmlRpcValue answer;
  const bool answered = client.execute("getPid", caller, answer);
  client.close();
  return answered && answer.size() == 3 ? static_cast<int>(answer[2]) : 0;
}

TEST(Respawn, ServesAgainAfterItWasKilled) {
  Bench bench("left_secondary");
  ASSERT_TRUE(bench.connect());
  for (int i = 0; i < 100; ++i) {
    bench.ask(kStart + i * kMillisecond, 1e-5 * i);
  }
  EXPECT_EQ(bench.forces.size(), 100U);

  const pid_t before = processOf("/simulate");
  ASSERT_GT(before, 0);
  ASSERT_EQ(kill(before, SIGKILL), 0);
  ASSERT_TRUE(spinUntil([&] { return !bench.isHeard(); }));
  ASSERT_TRUE(spinUntil([&] {
    const pid_t now = processOf("/simulate");
    return now > 0 && now != before;
  }));
  ASSERT_TRUE(bench.connect());

  DiagnosticsWatch diagnostics;
  // A new specimen at rest: 2 mm at the static stiffness of 3 kN/mm.
  EXPECT_NEAR(bench.ask(kStart + 200 * kMillisecond, 0.002).force, 6000.0, 1e-6);
  for (int i = 1; i < 50; ++i) {
    bench.ask(kStart + (200 + i) * kMillisecond, 0.002);
  }
  EXPECT_EQ(bench.forces.size(), 150U);
  EXPECT_TRUE(diagnostics.waitForCount("left_secondary", "accepted", 50));
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "respawn"); }
