// State files preserve every bit. Invalid files are refused, and only regular files are read or replaced.
#include "node/state_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include "support/files.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

std::vector<node::SavedState> states() {
  node::SavedState state;
  state.component = "left";
  state.model.elements = {{"spring", {{"stiffness", {3e6}}}}};
  state.started = true;
  state.stamp = 1234567890123456789;
  state.displacement = 0.1;
  state.memory = {1.0 / 3.0, -0.0, 5e-324, std::numeric_limits<double>::max()};
  node::SavedState other = state;
  other.component = "right";
  other.started = false;
  other.stamp = 0;
  return {state, other};
}

void expectRefusal(const std::string& text, const std::string& word) {
  const std::string message = messageOf<node::FileError>([&] { node::parseStates(text, "state.json"); });
  EXPECT_THAT(message, HasSubstr("state.json"));
  EXPECT_THAT(message, HasSubstr(word));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(StateText, KeepsEveryBit) {
  const std::vector<node::SavedState> read = node::parseStates(node::stateText(states()), "");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].stamp, 1234567890123456789);
  EXPECT_TRUE(read[0].started);
  EXPECT_FALSE(read[1].started);
  const std::vector<double> expected = states()[0].memory;
  ASSERT_EQ(read[0].memory.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(std::signbit(read[0].memory[i]), std::signbit(expected[i]));
    EXPECT_EQ(read[0].memory[i], expected[i]);
  }
}

TEST(StateText, StampsAreWholeNumbersThatAMessageCanHave) {
  const std::string text = node::stateText(states());
  for (const char* stamp : {"1e30", "18446744073709551616", "9223372036854775808", "4294967299999999999", "1.5", "-1",
                            "\"1\"", "null", "true", "[]"}) {
    expectRefusal(replaced(text, "1234567890123456789", stamp), "stamp_ns");
  }
}

TEST(StateText, NumbersAreNumbers) {
  const std::string text = node::stateText(states());
  for (const char* number : {"true", "null", "\"0.1\"", "[0.1]"}) {
    expectRefusal(replaced(text, "0.1,", std::string(number) + ","), "displacement_m");
  }
  expectRefusal(replaced(text, "3000000.0", "false"), "stiffness");
  expectRefusal(replaced(text, "0.1,", "1e999,"), "overflow");
}

TEST(StateText, AComponentStandsThereOnce) {
  expectRefusal(replaced(node::stateText(states()), "right", "left"), "twice");
}

TEST(StateText, NestingIsBounded) {
  for (const char* bracket : {"[", "{\"a\":"}) {
    std::string deep;
    for (int i = 0; i < 1000000; ++i) {
      deep += bracket;
    }
    expectRefusal(deep, "nested");
  }
  // Brackets within a string are not nested arrays.
  expectRefusal("{\"schema\": \"" + std::string(100, '[') + "\"}", "schema");
}

TEST(StateText, WhatIsNoStateIsRefused) {
  const std::string text = node::stateText(states());
  for (const std::string& bad :
       {std::string(), std::string("{}"), std::string("[]"), std::string("1"), text.substr(0, text.size() / 2),
        replaced(text, "state/1", "state/2"), replaced(text, "\"states\": [", "\"states\": [7, "),
        replaced(text, "\"values\": {", "\"values\": 7, \"other\": {")}) {
    expectRefusal(bad, "not a state file");
  }
}

class StateFile : public testing::Test {
 protected:
  void expectNeitherReadNorReplaced(const std::string& path, const std::string& word) const {
    for (const bool write : {false, true}) {
      const std::string message = messageOf<node::FileError>(
          [&] { write ? node::writeStateFile(path, states()) : static_cast<void>(node::readStateFile(path)); });
      EXPECT_THAT(message, HasSubstr(path));
      EXPECT_THAT(message, HasSubstr(word));
    }
  }

  ScratchFolder folder_;
  const std::string path_ = folder_.path("state.json");
};

TEST_F(StateFile, IsReadAsItWasWritten) {
  node::writeStateFile(path_, states());
  node::writeStateFile(path_, states());
  EXPECT_EQ(node::stateText(node::readStateFile(path_)), node::stateText(states()));
  const std::filesystem::directory_iterator folder(folder_.path());
  EXPECT_EQ(std::distance(begin(folder), end(folder)), 1) << "nothing is left beside it";
}

TEST_F(StateFile, IsARegularFile) {
  expectNeitherReadNorReplaced("/dev/zero", "a device");
  expectNeitherReadNorReplaced(folder_.path(), "a folder");
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  expectNeitherReadNorReplaced(path_, "a pipe");
  std::remove(path_.c_str());
  node::writeStateFile(folder_.path("target"), states());
  ASSERT_EQ(symlink(folder_.path("target").c_str(), path_.c_str()), 0);
  expectNeitherReadNorReplaced(path_, "a symbolic link");
}

TEST_F(StateFile, ThatCannotBeWrittenIsSaid) {
  EXPECT_THROW(node::writeStateFile(folder_.path("nowhere/state.json"), states()), node::FileError);
}

TEST_F(StateFile, IsBounded) {
  std::ofstream(path_) << std::string(node::kLargestStateFile + 1, ' ');
  EXPECT_THROW(node::readStateFile(path_), node::FileError);
}

TEST(RegularFile, ALinkToOneNamesAComponentFile) {
  EXPECT_THROW(node::requireRegularFile("/dev/zero"), node::FileError);
  EXPECT_THROW(node::requireRegularFile("/nowhere/at/all"), node::FileError);
  EXPECT_NO_THROW(node::requireRegularFile(std::string(TEST_DIR) + "/CMakeLists.txt"));
}

}  // namespace
}  // namespace rubber_suspension
