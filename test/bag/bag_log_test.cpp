// Logs in bags: written and read back bit by bit, without force, with several components, damaged, or misleading.
#include "bag/bag_log.h"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/bag.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/Force.h>

#include "bag/bag_writer.h"
#include "bag/header_stamp.h"
#include "rubber_suspension/gap/pose_replay.h"
#include "support/files.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

class BagLog : public testing::Test {
 protected:
  static log::Log log() {
    log::Log result;
    result.name = "log";
    result.stamp = {0, 1000000, 2500000, 1000000007};
    result.displacement = {0.1, 1.0 / 3.0, -2e-300, 5e-324};
    result.force = {1.0, -1.0 / 7.0, 1e29, 0.0};
    return result;
  }

  std::string path(const std::string& name) const { return folder_.folder() + "/" + name; }

  std::string refusal(const std::string& file, const std::string& component = "") const {
    const std::string error = messageOf<log::LogError>([&] { bag::readBagLog(file, component); });
    EXPECT_NE(error, "") << file << " was not refused";
    return error;
  }

  TemporaryFile folder_{"keep", ""};
};

TEST_F(BagLog, ReadsBackBitByBit) {
  bag::writeBagLog(path("a.bag"), "bush", log());
  const log::Log read = bag::readBagLog(path("a.bag"), "bush");
  EXPECT_EQ(read.name, "a");
  EXPECT_EQ(read.stamp, log().stamp);
  EXPECT_EQ(read.displacement, log().displacement);
  EXPECT_EQ(read.force, log().force);
  EXPECT_TRUE(read.notes.empty());
  EXPECT_EQ(bag::readAnyLog(path("a.bag")).displacement, log().displacement);
}

// On a full disk, closing the bag fails once more in the destructor, which must not throw.
TEST_F(BagLog, AFullDiskIsAnErrorAndLeavesNothing) {
  EXPECT_THROW(bag::writeBagLog("/dev/full", "bush", log()), log::LogError);
}

// The error about a truncated bag names the command that recovers its complete part.
TEST_F(BagLog, ABagThatIsCutSaysWhereAndWhatSavesIt) {
  const std::string file = path("a.bag");
  bag::writeBagLog(file, "bush", log());
  const auto size = std::filesystem::file_size(file);
  std::filesystem::resize_file(file, size - 5);
  EXPECT_THAT(refusal(file), HasSubstr("the bag is cut off at byte " + std::to_string(size - 5)));
  EXPECT_THAT(refusal(file), HasSubstr("rosbag reindex recovers the complete part"));
}

TEST_F(BagLog, TemperatureHoldsUntilTheNext) {
  log::Log warming = log();
  warming.temperature = {20.0, 20.0, 20.25, 20.25};
  bag::writeBagLog(path("a.bag"), "bush", warming);
  const log::Log read = bag::readBagLog(path("a.bag"));
  EXPECT_EQ(read.temperature, warming.temperature);
  EXPECT_TRUE(read.notes.empty());
}

// Temperatures that the node would refuse are omitted. Samples before the first temperature use it, with a note.
TEST_F(BagLog, TemperatureOfItsOwnStamps) {
  const std::string file = path("a.bag");
  {
    bag::BagWriter writer(file, "bush");
    for (int i = 0; i < 6; ++i) {
      writer.writeDisplacement(1000000000 + i * 10, 0.1 * i);
    }
    writer.writeTemperature(1000000015, 20.0);
    writer.writeTemperature(1000000020, std::nan(""));
    writer.writeTemperature(1000000040, 21.0);
    writer.close();
  }
  const log::Log read = bag::readBagLog(file);
  EXPECT_THAT(read.temperature, testing::ElementsAre(20.0, 20.0, 20.0, 20.0, 21.0, 21.0));
  EXPECT_THAT(read.notes, testing::ElementsAre(HasSubstr("2 samples before the first temperature")));
}

TEST_F(BagLog, ForceIsOptional) {
  log::Log plain = log();
  plain.force.clear();
  bag::writeBagLog(path("a.bag"), "bush", plain);
  EXPECT_TRUE(bag::readBagLog(path("a.bag")).force.empty());
}

TEST_F(BagLog, StampsThatNoHeaderHoldsAreShifted) {
  log::Log early = log();
  for (std::int64_t& stamp : early.stamp) {
    stamp -= 5000000000;
  }
  bag::writeBagLog(path("a.bag"), "bush", early);
  const log::Log read = bag::readBagLog(path("a.bag"));
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read.stamp[i] - read.stamp[0], log().stamp[i] - log().stamp[0]);
  }
}

TEST_F(BagLog, AMissingForceLeavesItsDisplacement) {
  const log::Log all = log();
  bag::BagWriter writer(path("a.bag"), "bush");
  for (std::size_t i = 0; i < all.size(); ++i) {
    writer.writeDisplacement(all.stamp[i], all.displacement[i]);
    if (i >= 1 && i <= 2) {
      writer.writeMeasuredForce(all.stamp[i], all.force[i]);
    }
  }
  writer.close();
  const log::Log read = bag::readBagLog(path("a.bag"));
  EXPECT_EQ(read.stamp, all.stamp);
  EXPECT_EQ(read.displacement, all.displacement);
  EXPECT_EQ(read.counts, (std::vector<double>{0.0, 1.0, 1.0, 0.0}));
  EXPECT_EQ(read.force[1], all.force[1]);
  EXPECT_EQ(read.force[2], all.force[2]);
  EXPECT_THAT(read.notes,
              testing::ElementsAre(HasSubstr("2 of 4 samples have a force; the others are simulated but not "
                                             "compared")));
  bag::writeBagLog(path("b.bag"), "bush", read);
  EXPECT_EQ(bag::readBagLog(path("b.bag")).counts, read.counts);
  log::writeLogCsv(path("b.csv"), read);
  EXPECT_EQ(log::readLog(path("b.csv")).counts, read.counts);
}

TEST_F(BagLog, ASlowForceIsComparedWhereItIs) {
  constexpr int kSamples = 400;
  bag::BagWriter writer(path("a.bag"), "bush");
  for (int i = 0; i < kSamples; ++i) {
    writer.writeDisplacement(1000000000 + i * 1000000, 1e-3 * i);
    if (i % 4 == 0) {
      writer.writeMeasuredForce(1000000000 + i * 1000000, 2.0 * i);
    }
  }
  writer.close();
  const log::Log read = bag::readBagLog(path("a.bag"));
  ASSERT_EQ(read.size(), static_cast<std::size_t>(kSamples));
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read.counts[i], i % 4 == 0 ? 1.0 : 0.0);
    EXPECT_EQ(read.force[i], 2.0 * static_cast<double>(std::min<std::size_t>(i, 396)));
  }
}

// The forces have another rate, and a clock that is 100 ppm fast. Interpolation is exact for a straight line.
TEST_F(BagLog, InterpolatesForcesOfADriftingClock) {
  constexpr int kSamples = 200;
  constexpr std::int64_t kInterval = 1000000;
  const auto line = [](std::int64_t stamp) { return 3.0 + 2e-6 * static_cast<double>(stamp); };
  bag::BagWriter writer(path("a.bag"), "bush");
  for (std::int64_t i = 0; i < kSamples; ++i) {
    writer.writeDisplacement((i + 1) * kInterval, 1e-3);
    const std::int64_t stamp = 700003 + i * 800080;
    if (i < 100 || i > 103) {  // the gap is too long to interpolate
      writer.writeMeasuredForce(stamp, line(stamp));
    }
  }
  writer.close();
  const log::Log read = bag::readBagLog(path("a.bag"));
  EXPECT_THAT(read.notes, testing::Contains(HasSubstr("has values at 1250 Hz in only 196 of")));
  ASSERT_EQ(read.size(), static_cast<std::size_t>(kSamples));
  for (std::size_t i = 0; i < read.size(); ++i) {
    const bool between = read.stamp[i] > 700003 + 99 * 800080 && read.stamp[i] < 700003 + 104 * 800080;
    const bool beyond = read.stamp[i] > 700003 + 199 * 800080;
    ASSERT_EQ(read.counts[i], between || beyond ? 0.0 : 1.0) << i;
    if (read.counts[i] > 0.0) {
      EXPECT_NEAR(read.force[i], line(read.stamp[i]), 1e-12 * line(read.stamp[i]));  // rounding errors
    }
  }
}

TEST_F(BagLog, AWriterThatIsNotClosedLeavesAnOlderBag) {
  bag::writeBagLog(path("a.bag"), "bush", log());
  {
    bag::BagWriter writer(path("a.bag"), "bush");
    writer.writeDisplacement(1000000, 1.0);
  }
  EXPECT_EQ(bag::readBagLog(path("a.bag")).displacement, log().displacement);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.folder()), {}), 2);  // this file and `keep`
}

TEST_F(BagLog, IsToldByItsContent) {
  bag::writeBagLog(path("a.log"), "bush", log());
  EXPECT_TRUE(bag::isBagPath(path("a.log")));
  EXPECT_EQ(bag::readAnyLog(path("a.log")).displacement, log().displacement);
}

TEST_F(BagLog, SeveralComponentsNeedAName) {
  rosbag::Bag bag(path("a.bag"), rosbag::bagmode::Write);
  for (const char* topic : {"/bench/left/displacement", "/bench/right/displacement"}) {
    for (int i = 1; i <= 3; ++i) {
      Displacement message;
      message.header.stamp = ros::Time(i);
      message.displacement = i;
      bag.write(topic, message.header.stamp, message);
    }
  }
  bag.close();
  EXPECT_THAT(refusal(path("a.bag")), HasSubstr("/bench/left/displacement, /bench/right/displacement"));
  EXPECT_THAT(refusal(path("a.bag"), "middle"), HasSubstr("/middle/displacement"));
  EXPECT_THAT(refusal(path("a.bag"), "eft"), HasSubstr("/eft/displacement"));
  EXPECT_EQ(bag::readBagLog(path("a.bag"), "left").size(), 3U);
}

TEST_F(BagLog, RefusesStampsThatDoNotIncrease) {
  bag::BagWriter writer(path("a.bag"), "bush");
  writer.writeDisplacement(2000, 0.0);
  writer.writeDisplacement(1000, 0.0);
  writer.writeDisplacement(3000, 0.0);
  writer.close();
  // A bag is read in the order of recording. Here this is also the order of stamps, so only equal stamps are refused.
  EXPECT_EQ(bag::readBagLog(path("a.bag")).size(), 3U);
  bag::BagWriter twice(path("b.bag"), "bush");
  twice.writeDisplacement(1000, 0.0);
  twice.writeDisplacement(1000, 1.0);
  twice.close();
  EXPECT_THAT(refusal(path("b.bag")), HasSubstr("message 2 on /bush/displacement"));
}

// Writes a bag with messages of these stamps, received in this order, 1 ms apart.
class BagStamps : public BagLog {
 protected:
  std::string write(const std::vector<double>& stamps) const {
    rosbag::Bag bag(path("stamps.bag"), rosbag::bagmode::Write);
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      Displacement message;
      message.header.stamp = ros::Time(stamps[i]);
      message.displacement = static_cast<double>(i);
      bag.write("/bush/displacement", ros::Time(100.0 + 1e-3 * static_cast<double>(i)), message);
    }
    bag.close();
    return path("stamps.bag");
  }
};

TEST_F(BagStamps, NobodyFilledAreRefusedWithTheOptionsThatReadThem) {
  const std::string file = write(std::vector<double>(200, 0.0));
  EXPECT_THAT(refusal(file),
              AllOf(HasSubstr("header.stamp is 0 in each of 200 messages: the publisher does not set it"),
                    HasSubstr("--clock receipt (1000 Hz, steps of 1 to 1 ms)"), HasSubstr("--sampling-rate 1000")));
  const auto by = [](double rate, const std::string& clock) {
    return log::makeLogFormat({}, "", rate, "", "", -1.0, "", clock);
  };
  for (const log::LogFormat& format : {by(0.0, "receipt"), by(1000.0, "")}) {
    const log::Log read = bag::readBagLog(file, "", format);
    ASSERT_EQ(read.size(), 200U);
    EXPECT_NEAR(read.time(199) - read.time(0), 0.199, 1e-9);
  }
}

TEST_F(BagStamps, TellThePlaceOfAMessageThatWasOvertaken) {
  const log::Log read = bag::readBagLog(write({1.0, 1.001, 1.003, 1.002, 1.004}));
  EXPECT_THAT(read.displacement, testing::ElementsAre(0.0, 1.0, 3.0, 2.0, 4.0));
  EXPECT_THAT(read.notes, testing::ElementsAre(HasSubstr("1 of 5 messages follow messages with later stamps")));
}

TEST_F(BagStamps, OfOneMessageWithoutLeaveItOut) {
  const log::Log read = bag::readBagLog(write({1.0, 1.001, 0.0, 1.003}));
  EXPECT_THAT(read.displacement, testing::ElementsAre(0.0, 1.0, 3.0));
  EXPECT_THAT(read.notes, testing::ElementsAre(HasSubstr("1 of 4 messages have the stamp 0: omitted")));
}

// The bag contains two runs, whose samples must not be mixed.
TEST_F(BagStamps, ThatBeginAnewAreRefused) {
  EXPECT_THAT(refusal(write({10.0, 11.0, 12.0, 10.5, 11.5})), HasSubstr("message 4 on /bush/displacement"));
}

TEST_F(BagLog, RefusesATopicOfAnotherType) {
  rosbag::Bag bag(path("a.bag"), rosbag::bagmode::Write);
  Force message;
  message.header.stamp = ros::Time(1);
  bag.write("/bush/displacement", message.header.stamp, message);
  bag.close();
  EXPECT_THAT(refusal(path("a.bag")), HasSubstr("rubber_suspension/Displacement"));
}

TEST_F(BagLog, RefusesWhatIsNoBag) {
  EXPECT_THAT(refusal(path("none.bag")), HasSubstr(path("none.bag")));
  std::ofstream(path("text.bag")) << "time_s,displacement_m\n0,0\n";
  EXPECT_THAT(refusal(path("text.bag")), HasSubstr(path("text.bag")));
  std::ofstream(path("empty.bag")).flush();
  EXPECT_THAT(refusal(path("empty.bag")), HasSubstr(path("empty.bag")));
}

// A truncated bag, or a changed byte in the part that rosbag relies on, does not lead to a crash.
TEST_F(BagLog, SurvivesDamage) {
  bag::writeBagLog(path("a.bag"), "bush", log());
  const std::string whole = contentOf(path("a.bag"));
  const auto attempt = [&](const std::string& bytes) {
    std::ofstream(path("damaged.bag"), std::ios::binary) << bytes;
    try {
      bag::readBagLog(path("damaged.bag"));
    } catch (const log::LogError&) {  // a damaged bag may be refused
    }
  };
  for (std::size_t size = 0; size < whole.size(); size += 197) {
    attempt(whole.substr(0, size));
  }
  const std::size_t index = whole.find("op=\x04");  // behind the only chunk
  ASSERT_NE(index, std::string::npos);
  for (const char mask : {'\x01', '\x55', '\x80'}) {
    for (std::size_t place = 0; place < whole.size(); place += place < index - 100 ? 211 : 1) {
      std::string bytes = whole;
      bytes[place] = static_cast<char>(bytes[place] ^ mask);
      attempt(bytes);
    }
  }
}

// A bag with five poses, a wrench for each but the first, and quaternions of a given length.
class BagPoses : public BagLog {
 protected:
  static Eigen::Quaterniond rotationOf(int sample) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(0.05 * sample, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()));
  }

  std::string write(double length = 1.0) const {
    rosbag::Bag bag(path("poses.bag"), rosbag::bagmode::Write);
    for (int i = 0; i < 5; ++i) {
      geometry_msgs::PoseStamped pose;
      pose.header.stamp = bag::toRosTime(1000000000 + i * 4000000);
      pose.pose.position.x = 1e-3 * i;
      pose.pose.position.z = -2e-3 / (1 + i);
      const Eigen::Quaterniond rotation = rotationOf(i);
      pose.pose.orientation.w = length * rotation.w();
      pose.pose.orientation.x = length * rotation.x();
      pose.pose.orientation.y = length * rotation.y();
      pose.pose.orientation.z = length * rotation.z();
      bag.write("/bench/bush/pose", pose.header.stamp, pose);
      geometry_msgs::WrenchStamped wrench;
      wrench.header = pose.header;
      wrench.wrench.force.y = 10.0 * i;
      wrench.wrench.torque.z = -0.1 * i;
      if (i > 0) {
        bag.write("/bench/bush/measured_wrench", pose.header.stamp, wrench);
      }
    }
    bag.close();
    return path("poses.bag");
  }

  static std::string refusalOf(const std::string& file, const std::string& component) {
    return messageOf<log::LogError>([&] { bag::readBagPoses(file, component, component::RotationMeasure::vector); });
  }
};

TEST_F(BagPoses, HaveTheWrenchesOfTheirStamps) {
  const log::PoseLog log = bag::readBagPoses(write(), "bush", component::RotationMeasure::vector);
  EXPECT_THAT(log.counts, testing::ElementsAre(0.0, 1.0, 1.0, 1.0, 1.0));  // the first pose has no wrench
  EXPECT_EQ(log.name, "poses");
  EXPECT_EQ(log.stamp[1], 1004000000);
  EXPECT_EQ(log.coordinate[0][3], 3e-3);
  EXPECT_EQ(log.coordinate[2][2], -2e-3 / 3.0);
  const Eigen::Vector3d turn = 0.05 * 4 * Eigen::Vector3d(1.0, 2.0, -0.5).normalized();
  EXPECT_NEAR(log.coordinate[4][4], turn.y(), 1e-15);
  EXPECT_EQ(log.wrench[1][4], 40.0);
  EXPECT_EQ(log.wrench[5][1], -0.1);
  EXPECT_THAT(log.notes, testing::ElementsAre(HasSubstr("4 of 5 samples have a force")));
}

// Neither the node nor the simulation of a bag normalises quaternions.
TEST_F(BagPoses, AreSimulatedAsTheNodeDoesToTheLastBit) {
  component::SixDirectionsLaws laws;
  for (auto& elements : laws.elements) {
    elements = {{"spring", {{"stiffness", {1e4}}}}, {"maxwell", {{"stiffness", {7e3}}, {"break_frequency", {3.0}}}}};
  }
  for (const auto measure : {component::RotationMeasure::vector, component::RotationMeasure::cardan}) {
    laws.measure = measure;
    const component::SixDirections bush(laws);
    const log::PoseLog log = bag::readBagPoses(write(), "", measure);
    const gap::PoseReplay replay = gap::replayPoses(bush, log);
    component::PoseStream node(bush);
    for (int i = 0; i < 5; ++i) {
      const auto answer = node.push(1000000000 + i * 4000000, {1e-3 * i, 0.0, -2e-3 / (1 + i)}, rotationOf(i));
      const auto sample = static_cast<std::size_t>(i);
      EXPECT_EQ(replay.wrench[2][sample], answer.force.wrench.force.z());
      EXPECT_EQ(replay.wrench[4][sample], answer.force.wrench.moment.y());
    }
  }
}

TEST_F(BagPoses, AreRefusedAsTheNodeDropsThem) {
  EXPECT_THAT(refusalOf(write(1.002), "bush"),
              HasSubstr("message 1 on /bench/bush/pose: a quaternion of length 1.002; accepted: 1 +- 0.001"));
  EXPECT_THAT(refusalOf(write(), "other"), HasSubstr("no topic ends in /other/pose; the bag has /bench/bush/pose"));
  bag::writeBagLog(path("a.bag"), "bush", log());
  EXPECT_THAT(refusalOf(path("a.bag"), "bush"), HasSubstr("the bag has no pose at all"));
  const std::string message = messageOf<log::LogError>([&] { bag::readBagLog(write(), "bush"); });
  EXPECT_THAT(message,
              HasSubstr("no displacement at all; accepted: --columns displacement=/TOPIC/FIELD "
                        "force=/TOPIC/FIELD, where /TOPIC is one of /bench/bush/measured_wrench, /bench/bush/pose"));
}

}  // namespace
}  // namespace rubber_suspension
