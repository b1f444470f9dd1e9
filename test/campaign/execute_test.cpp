// A job gives the same results as the command that it represents, to the last byte.
#include "campaign/execute.h"

#include "campaign/campaign_folder.h"
#include "command/identify.h"
#include "diagnosis/report/augmented_yaml.h"
#include "diagnosis/rig.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

class ExecuteJob : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("c.yaml", io::toYaml({rigComponent()}));
    for (unsigned seed : {1U, 2U}) {
      const std::string name = "log_" + std::to_string(seed);
      const auto friction = [](double, double displacement, double rate) {
        return 150.0 * std::tanh(rate / 1e-3) + 0.0 * displacement;
      };
      log::writeLogCsv(folder_.path(name + ".csv"), runRig(name, seed, friction));
    }
  }

  // Returns the record of the single job of a jobs file.
  campaign::Record execute(const std::string& command) {
    folder_.write("jobs.yaml", "jobs:\n  one:\n    command: " + command + "\n    config: c.yaml\n    log: log_*.csv\n");
    const campaign::Manifest manifest =
        campaign::makeManifest(folder_.path("jobs.yaml"), folder_.path("out"), "1.0", 1, readTestLog).manifest;
    campaign::Record record = campaign::executorOf(folder_.path("out"), manifest, readTestLog)(manifest.jobs.at(0));
    const campaign::FoundRecord found =
        campaign::findRecord(folder_.path("out"), manifest.jobs[0].id, "1.0", campaign::FileCheck::digests);
    EXPECT_EQ(found.problem, "");
    EXPECT_EQ(found.record.value().values.dump(),
              record.values.dump());  // numbers that are not finite are null
    EXPECT_EQ(found.record.value().findings.changes, record.findings.changes);
    report_ = "out/" + campaign::reportFolder(manifest.jobs[0].id) + "/";
    return record;
  }

  io::ComponentDescription component() const { return io::loadComponentFile(folder_.path("c.yaml")).front(); }

  std::vector<log::Log> logs() const {
    return {log::readLog(folder_.path("log_1.csv")), log::readLog(folder_.path("log_2.csv"))};
  }

  CampaignFolder folder_;
  std::string report_;
};

TEST_F(ExecuteJob, DiagnosesAsTheCommandDoes) {
  const campaign::Record record = execute("diagnose");
  ASSERT_EQ(record.error, "");
  diagnosis::DiagnosisOptions settings;
  settings.threads = 1;
  const diagnosis::Diagnosis expected = diagnosis::diagnose(component(), logs(), {}, settings);
  EXPECT_EQ(folder_.read(report_ + "report.json"), diagnosis::toJson(expected));
  EXPECT_EQ(folder_.read(report_ + "augmented.yaml"), diagnosis::report::augmentedYaml(expected));
  EXPECT_EQ(record.values.at("verdict"), toString(expected.answer.verdict));
  EXPECT_EQ(record.values.at("gap_augmented"), expected.gaps.unseen.augmented);
  EXPECT_EQ(record.findings.verdict, expected.answer.verdict);
  EXPECT_EQ(record.findings.effects, expected.answer.effects);
  EXPECT_FALSE(folder_.holds(report_ + "evidence.json"));
}

TEST_F(ExecuteJob, LeavesItsEvidenceWhereItIsAskedFor) {
  const campaign::Record record = execute("diagnose\n    evidence: true");
  ASSERT_EQ(record.error, "");
  EXPECT_EQ(record.files.count("evidence.json"), 1U);
  diagnosis::DiagnosisOptions settings;
  settings.threads = 1;
  settings.evidence = true;
  EXPECT_EQ(folder_.read(report_ + "evidence.json"),
            diagnosis::evidenceJson(diagnosis::diagnose(component(), logs(), {}, settings)));
}

TEST_F(ExecuteJob, LeavesTheRigOutWhereItIsToldTo) {
  io::ComponentDescription on_a_rig = component();
  on_a_rig.add = {{"inertia", {{"mass", {50.0}}}, true}};
  folder_.write("c.yaml", io::toYaml({on_a_rig}));
  const auto gapOf = [&](const io::ComponentDescription& description) {
    return gap::relativeGap(logs()[0].force, gap::simulateLog(description.makeComponent(), logs()[0]));
  };
  EXPECT_EQ(execute("replay").values.at("gap"), gapOf(on_a_rig));
  EXPECT_EQ(execute("replay\n    without_rig: true").values.at("gap"), gapOf(on_a_rig.withoutRig()));
}

TEST_F(ExecuteJob, EstimatesAsTheCommandDoes) {
  const campaign::Record record = execute("estimate");
  ASSERT_EQ(record.error, "");
  const fit::Identification expected = command::identifyFromLogs(component(), logs(), {});
  EXPECT_EQ(folder_.read(report_ + "identification.json"), command::toJson("bush", expected));
  EXPECT_EQ(record.values.at("residual_n"), expected.residual);
  for (const fit::IdentifiedParameter& parameter : expected.parameters) {
    const std::string name = fmt::format("{}_{}.{}", parameter.element, parameter.index, parameter.name);
    EXPECT_EQ(record.findings.changes.count(name), parameter.determined ? 1U : 0U) << name;
  }
}

TEST_F(ExecuteJob, ALogThatCannotBeUsedIsItsError) {
  folder_.writeLog("log_1.csv");
  std::string text = "time_s,displacement_m,force_N\n";
  for (int i = 0; i < 10; ++i) {
    text += fmt::format("0.{},0.00{},{}\n", i, i, i);
  }
  folder_.write("log_1.csv", text);
  const campaign::Record record = execute("diagnose");
  EXPECT_THAT(record.error, HasSubstr("log_1"));
  EXPECT_TRUE(record.values.empty());
}

}  // namespace
}  // namespace rubber_suspension
