// Tolerances of a rig: texts with units or shares, options, component files, refusals.
#include "rubber_suspension/io/rig_tolerances.h"

#include "rubber_suspension/io/component_file.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(RigTolerances, TakeUnitsAndShares) {
  io::RigTolerances tolerances;
  io::setRigTolerance(tolerances, "force_zero=0.05 kN");
  EXPECT_DOUBLE_EQ(tolerances.force_zero.value, 50.0);
  EXPECT_FALSE(tolerances.force_zero.is_share);
  io::setRigTolerance(tolerances, "delay = 0.2 ms");
  EXPECT_DOUBLE_EQ(tolerances.delay.value, 2e-4);
  io::setRigTolerance(tolerances, "gain=1 %");
  EXPECT_DOUBLE_EQ(tolerances.gain.value, 0.01);
  EXPECT_TRUE(tolerances.gain.is_share);
  io::setRigTolerance(tolerances, "displacement_zero=0");
  EXPECT_EQ(tolerances.displacement_zero.value, 0.0);
}

TEST(RigTolerances, NameWhatTheyRefuse) {
  const auto refusal = [](const std::string& text) {
    io::RigTolerances tolerances;
    return messageOf<std::invalid_argument>([&] { io::setRigTolerance(tolerances, text); });
  };
  for (const char* text : {"force_zero", "zero=1", "force_zero=1 m", "force_zero=-1 N", "delay=nan", "gain=2 N"}) {
    EXPECT_THAT(refusal(text), HasSubstr("; accepted: ")) << text;
  }
  EXPECT_THAT(refusal("zero=1"), HasSubstr("displacement_zero"));
}

TEST(RigTolerances, AreReadAndWrittenInComponentFiles) {
  const std::string text =
      "components:\n  bush:\n    model: elements\n    elements:\n      - {type: spring, stiffness: 1e6}\n"
      "    rig:\n      force_zero: 50 N\n      delay: 20 %\n";
  const auto components = io::parseComponentFile(text, "file.yaml");
  ASSERT_TRUE(components[0].rig);
  const auto again = io::parseComponentFile(io::toYaml(components), "written");
  ASSERT_TRUE(again[0].rig);
  for (const io::RigToleranceInfo& row : io::rigToleranceTable()) {
    const io::RigTolerance& one = (*components[0].rig).*row.member;
    const io::RigTolerance& other = (*again[0].rig).*row.member;
    EXPECT_DOUBLE_EQ(one.value, other.value) << row.name;
    EXPECT_EQ(one.is_share, other.is_share) << row.name;
  }
}

}  // namespace
}  // namespace rubber_suspension
