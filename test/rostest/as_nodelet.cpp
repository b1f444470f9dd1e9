// Tests the nodelet: its forces equal those of the node, no message is copied, and bad configurations are refused.
#include <net/if.h>
#include <netinet/in.h>
#include <nodelet/loader.h>
#include <ros/network.h>
#include <ros/xmlrpc_manager.h>
#include <sys/socket.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "bench.h"
#include "ros_interface/process_fixes.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension {
namespace {

constexpr const char* kType = "rubber_suspension/simulate";

// Returns the network interface of a listening TCP port of this process, or an empty string if it listens on all.
std::string interfaceOf(std::uint32_t port) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int file = std::stoi(entry.path().filename().string());
    int listens = 0;
    sockaddr_in address{};
    std::array<char, IFNAMSIZ> name{};
    socklen_t size = sizeof(listens);
    socklen_t address_size = sizeof(address);
    socklen_t name_size = name.size();
    if (getsockopt(file, SOL_SOCKET, SO_ACCEPTCONN, &listens, &size) == 0 && listens != 0 &&
        getsockname(file, reinterpret_cast<sockaddr*>(&address), &address_size) == 0 &&
        ntohs(address.sin_port) == port &&
        getsockopt(file, SOL_SOCKET, SO_BINDTODEVICE, name.data(), &name_size) == 0) {
      return name.data();
    }
  }
  ADD_FAILURE() << "nothing listens on " << port;
  return {};
}

TEST(Nodelet, AnswersWithoutCopies) {
  nodelet::Loader loader;
  ASSERT_TRUE(loader.load("/simulate", kType, {}, {}));
  ros::NodeHandle handle;
  std::vector<Force::ConstPtr> forces;
  const ros::Subscriber subscriber = handle.subscribe<Force>(
      "left_secondary/force", 1000, [&](const Force::ConstPtr& force) { forces.push_back(force); });
  const ros::Publisher publisher = handle.advertise<Displacement>("left_secondary/displacement", 1000);
  ASSERT_TRUE(spinUntil([&] { return subscriber.getNumPublishers() > 0 && publisher.getNumSubscribers() > 0; }));

  const auto components = io::loadComponentFile(std::string(TEST_DIR) + "/rostest/config/two_components.yaml");
  const component::Component component = io::selectComponent(components, "left_secondary").makeComponent();
  component::SampleStream expected(component);
  std::set<const Force*> addresses;
  constexpr std::size_t kSamples = 1000;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const auto sample = boost::make_shared<Displacement>();
    const std::int64_t stamp = kStart + static_cast<std::int64_t>(i) * kMillisecond;
    sample->header.stamp = bag::toRosTime(stamp);
    sample->displacement = 1e-3 * std::sin(0.02 * static_cast<double>(i));
    publisher.publish(sample);
    ASSERT_TRUE(spinUntil([&] { return !forces.empty(); }));
    ASSERT_EQ(forces.size(), 1U);
    EXPECT_EQ(forces[0]->force, expected.push(stamp, sample->displacement).force.total);
    addresses.insert(forces[0].get());
    forces.clear();
  }
  // The server publishes messages from a pool, and reuses a message only when no subscriber uses it. Copies of messages
  // would have many more addresses.
  EXPECT_LE(addresses.size(), 32U);
  EXPECT_TRUE(loader.unload("/simulate"));
}

TEST(Nodelet, KeepsToTheLoopbackInterfaceWhereRosDoes) {
  nodelet::Loader loader;
  ASSERT_TRUE(loader.load("/simulate", kType, {}, {}));
  // If the kernel does not permit the restriction, the node reports that and continues.
  const std::string& host = ros::network::getHost();
  const bool expected =
      (host == "localhost" || host.compare(0, 4, "127.") == 0) && ros_interface::keepSlaveApiToLoopback().empty();
  EXPECT_EQ(interfaceOf(ros::XMLRPCManager::instance()->getServerPort()), expected ? "lo" : "");
  EXPECT_TRUE(loader.unload("/simulate"));
}

TEST(Nodelet, ASecondOneDoesNotServeTheSameComponent) {
  nodelet::Loader loader;
  ros::param::set("/second/config_file", std::string(TEST_DIR) + "/rostest/config/two_components.yaml");
  ASSERT_TRUE(loader.load("/simulate", kType, {}, {}));
  EXPECT_FALSE(loader.load("/second", kType, {}, {}));
  EXPECT_TRUE(loader.unload("/simulate"));
  EXPECT_TRUE(loader.load("/second", kType, {}, {})) << "once the first has gone";
  EXPECT_TRUE(loader.unload("/second"));
}

TEST(Nodelet, ABadConfigurationIsNotLoaded) {
  nodelet::Loader loader;
  ros::param::set("/bad/config_file", "/nowhere/bad.yaml");
  EXPECT_FALSE(loader.load("/bad", kType, {}, {}));
  EXPECT_TRUE(loader.listLoadedNodelets().empty());
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "as_nodelet"); }
