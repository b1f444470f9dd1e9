// Friction that differs between logs, as in a seal at different pressures, and friction that is equal in all logs.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

// Returns the friction of all test rigs times a factor.
RigEffect frictionTimes(double factor) {
  return [factor, friction = rigFriction()](double time, double z, double rate) {
    return factor * friction(time, z, rate);
  };
}

diagnosis::Diagnosis diagnoseFactors(const std::vector<double>& factors) {
  std::vector<log::Log> logs;
  for (const double factor : factors) {
    const auto seed = static_cast<unsigned>(logs.size() + 1);
    logs.push_back(runRig("log_" + std::to_string(seed), seed, frictionTimes(factor)));
  }
  return checkedDiagnosis(rigComponent(), logs, {});
}

TEST(FrictionFactors, AreToldWhereTheLogsDiffer) {
  const diagnosis::Diagnosis found = diagnoseFactors({0.5, 1.5, 4.0});
  ASSERT_EQ(found.answer.effects, std::vector<std::string>{"friction"}) << found.sentence;
  EXPECT_NE(found.sentence.find("Friction differs between the logs"), std::string::npos) << found.sentence;
  const auto& search = found.workings->search;
  const auto named = std::find_if(search.singles.begin(), search.singles.end(), [&](const auto& single) {
    return search.candidates[static_cast<std::size_t>(single.hypothesis.members.front())].effect == "friction";
  });
  ASSERT_NE(named, search.singles.end());
  EXPECT_LT(named->fit.held_out, 1.5 * search.noise.floor) << "nothing but noise is left";
}

TEST(FrictionFactors, AreNoneWhereTheLogsAgree) {
  const diagnosis::Diagnosis found = diagnoseFactors({1.0, 1.0});
  ASSERT_EQ(found.answer.effects, std::vector<std::string>{"friction"}) << found.sentence;
  EXPECT_EQ(found.sentence.find("Friction differs"), std::string::npos) << found.sentence;
}

}  // namespace
}  // namespace rubber_suspension
