// Numbers in messages of other packages have paths as names, as in rosbag and PlotJuggler.
#include "bag/message_field.h"

#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/bag.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Float64.h>

#include <cstring>

#include "bag/bag_log.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {

// A message as bytes, with any definition.
struct RawMessage {
  std::string definition;
  std::vector<std::uint8_t> bytes;
};

}  // namespace rubber_suspension

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<rubber_suspension::RawMessage> {
  static const char* value(const rubber_suspension::RawMessage&) { return "0123456789abcdef0123456789abcdef"; }
};

template <>
struct DataType<rubber_suspension::RawMessage> {
  static const char* value(const rubber_suspension::RawMessage&) { return "odd/Message"; }
};

template <>
struct Definition<rubber_suspension::RawMessage> {
  static const char* value(const rubber_suspension::RawMessage& message) { return message.definition.c_str(); }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<rubber_suspension::RawMessage> {
  template <class Stream>
  static void write(Stream& stream, const rubber_suspension::RawMessage& message) {
    const auto size = static_cast<std::uint32_t>(message.bytes.size());
    std::memcpy(stream.advance(size), message.bytes.data(), size);
  }
  static std::uint32_t serializedLength(const rubber_suspension::RawMessage& message) {
    return static_cast<std::uint32_t>(message.bytes.size());
  }
};

}  // namespace serialization
}  // namespace ros

namespace rubber_suspension {
namespace {

constexpr int kMessages = 50;

double displacementAt(int i) { return 1e-3 * std::sin(0.2 * i); }
ros::Time stampAt(int i) { return ros::Time(100, 0) + ros::Duration(0.01 * i); }

// Writes a bag of another package: forces, joints (the second is the displacement), a load cell without stamps.
void writeForeignBag(const std::string& path) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  for (int i = 0; i < kMessages; ++i) {
    geometry_msgs::WrenchStamped wrench;
    wrench.header.stamp = stampAt(i);
    wrench.header.frame_id = "cell";
    wrench.wrench.force.z = -2e6 * displacementAt(i);
    bag.write("/ft/wrench", stampAt(i), wrench);
    sensor_msgs::JointState joints;
    joints.header.stamp = stampAt(i);
    joints.name = {"boom", "knee"};
    joints.position = {7.0, displacementAt(i)};
    bag.write("/joint_states", stampAt(i), joints);
    std_msgs::Float64 cell;
    cell.data = 2.0 * displacementAt(i);
    bag.write("/cell", stampAt(i), cell);
  }
}

class MessageField : public testing::Test {
 protected:
  MessageField() { writeForeignBag(file_.path()); }

  log::Log read(const std::vector<std::string>& columns, const std::string& unit = "") const {
    return bag::readBagLog(file_.path(), "", log::makeLogFormat(columns, unit, 0.0));
  }

  std::string refusal(const std::vector<std::string>& columns) const {
    return messageOf<log::LogError>([&] { read(columns); });
  }

  void expectNumbers(const log::Log& log) const {
    ASSERT_EQ(log.size(), static_cast<std::size_t>(kMessages));
    ASSERT_EQ(log.force.size(), log.size());
    for (int i = 0; i < kMessages; ++i) {
      const auto place = static_cast<std::size_t>(i);
      EXPECT_EQ(log.stamp[place], static_cast<std::int64_t>(stampAt(i).toNSec()));
      EXPECT_EQ(log.displacement[place], displacementAt(i));
      EXPECT_EQ(log.force[place], 2e6 * displacementAt(i));
    }
  }

  TemporaryFile file_{"bench.bag", ""};
};

TEST_F(MessageField, IsFoundByTopicAndPath) {
  for (const char* force :
       {"force=-/ft/wrench/wrench/force/z", "force=-/ft/wrench.wrench.force.z", "force=-/ft/wrench.force.z"}) {
    for (const char* displacement :
         {"displacement=/joint_states/position[knee]", "displacement=/joint_states.position[1]"}) {
      SCOPED_TRACE(std::string(force) + " " + displacement);
      expectNumbers(read({force, displacement}));
    }
  }
}

TEST_F(MessageField, OfATopicWithoutStampsHasTheTimeOfReceipt) {
  expectNumbers(read({"force=1e6*/cell", "displacement=/joint_states/position[knee]"}));
  EXPECT_DOUBLE_EQ(read({"force=/cell.data", "displacement=/joint_states/position[1]"}, "force=kN").force[1],
                   2e3 * displacementAt(1));
}

TEST_F(MessageField, IsRefusedByNameWhereItIsNotThere) {
  const std::string displacement = "displacement=/joint_states/position[1]";
  EXPECT_THAT(refusal({"force=/ft/torque"}), HasSubstr("displacement=/TOPIC/FIELD"));
  EXPECT_THAT(refusal({displacement, "force=/nothing/here"}),
              HasSubstr("accepted: one of /cell, /ft/wrench, /joint_states"));
  EXPECT_THAT(refusal({displacement, "force=/ft/wrench.strain"}),
              HasSubstr("no field 'strain'; accepted: one of header, wrench"));
  EXPECT_THAT(refusal({"displacement=/joint_states/position[9]"}), HasSubstr("message 1: the field has no number"));
  EXPECT_THAT(refusal({"displacement=/joint_states/name[0]"}), HasSubstr("a field of type string"));
}

// Reads a field of two messages. Their bytes are a count without any elements behind it, and the number 3.
log::Log readWithDefinition(const std::string& definition, std::uint32_t count, const std::string& field = "data") {
  const TemporaryFile file("odd.bag", "");
  constexpr double kNumber = 3.0;
  RawMessage message{definition, std::vector<std::uint8_t>(sizeof count + sizeof kNumber)};
  std::memcpy(message.bytes.data(), &count, sizeof count);
  std::memcpy(message.bytes.data() + sizeof count, &kNumber, sizeof kNumber);
  {
    rosbag::Bag bag(file.path(), rosbag::bagmode::Write);
    bag.write("/odd", stampAt(0), message);
    bag.write("/odd", stampAt(1), message);
  }
  return bag::readBagLog(file.path(), "", log::makeLogFormat({"displacement=/odd/" + field}, "", 0.0));
}

TEST(DefinitionOfAMessage, MayHaveAnyNumberOfElementsWithoutFields) {
  const std::string definition =
      "odd/Nothing[] many\nodd/Twice twice\nfloat64 data\n===\nMSG: odd/Nothing\n===\n"
      "MSG: odd/Twice\nodd/Nothing a\nodd/Nothing[2] b\n";
  EXPECT_EQ(readWithDefinition(definition, 0xffffffff).displacement, (std::vector<double>{3.0, 3.0}));
  EXPECT_THAT(messageOf<log::LogError>([&] { readWithDefinition(definition, 0xffffffff, "many[missing]"); }),
              HasSubstr("the field has no number"));
}

TEST(DefinitionOfAMessage, IsRefusedIfATypeContainsItself) {
  const std::string definition = "odd/Own own\nuint32 count\nfloat64 data\n===\nMSG: odd/Own\nodd/Own own\n";
  EXPECT_THAT(messageOf<log::LogError>([&] { readWithDefinition(definition, 0); }),
              HasSubstr("a type that contains itself: 'odd/Own'"));
}

}  // namespace
}  // namespace rubber_suspension
