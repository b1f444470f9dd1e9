// Shares, medians and outliers of fleets with known truth, and compared with published tables.
#include "campaign/fleet.h"

#include <nlohmann/json.hpp>

#include "support/test.h"

namespace rubber_suspension {
namespace {

using Json = nlohmann::ordered_json;

campaign::Job job(int number, const std::string& type = "bush") {
  campaign::Job job;
  job.id = std::string(64 - std::to_string(number).size(), '0') + std::to_string(number);
  job.type = type;
  job.component = "bush";
  job.test_piece = "truck_" + std::to_string(number);
  return job;
}

campaign::Record diagnosis(diagnosis::Verdict verdict, const std::vector<std::string>& effects = {}) {
  campaign::Record record;
  record.findings.verdict = verdict;
  record.findings.effects = effects;
  return record;
}

campaign::Record withChange(double logarithm) {
  campaign::Record record = diagnosis(diagnosis::Verdict::parameter_error);
  record.findings.changes["static_stiffness"] = logarithm;
  return record;
}

Json analyse(const std::vector<campaign::Record>& records) {
  campaign::Fleet fleet;
  for (std::size_t i = 0; i < records.size(); ++i) {
    fleet.add(job(static_cast<int>(i)), records[i]);
  }
  return fleet.analyse().at("types").at(0);
}

std::vector<campaign::Record> scatteringFleet(double mean, double scatter, std::size_t components = 30) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(mean, scatter);
  std::vector<campaign::Record> records;
  for (std::size_t i = 0; i < components; ++i) {
    records.push_back(withChange(normal(generator)));
  }
  return records;
}

std::vector<std::string> farOut(const Json& type) {
  std::vector<std::string> components;
  for (const Json& one : type.at("far_out")) {
    components.push_back(one.at("component"));
  }
  return components;
}

using Ends = std::array<double, 2>;

TEST(Distributions, HaveQuartilesBetweenTheirValues) {
  EXPECT_EQ(campaign::distributionOf({4.0, 1.0, 3.0, 2.0}).dump(),
            R"({"components":4,"median":2.5,"quartiles":[1.75,3.25]})");
  EXPECT_EQ(campaign::distributionOf({7.0}).dump(), R"({"components":1,"median":7.0,"quartiles":[7.0,7.0]})");
}

// Published tables of the sign test give these ranks: the 2nd and 9th of 10 values (97.9 %), the 6th and 15th of 20
// (95.9 %), the 8th and 18th of 25 (95.7 %), and no interval for 5 values.
TEST(Distributions, TheIntervalOfTheMedianHasTheRanksOfTables) {
  const auto interval = [](int count) {
    std::vector<double> values(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      values[static_cast<std::size_t>(i)] = i + 1.0;
    }
    return campaign::distributionOf(values).value("median_interval_95", Ends{});
  };
  EXPECT_EQ(interval(5), Ends{});
  EXPECT_EQ(interval(6), (Ends{1.0, 6.0}));
  EXPECT_EQ(interval(10), (Ends{2.0, 9.0}));
  EXPECT_EQ(interval(20), (Ends{6.0, 15.0}));
  EXPECT_EQ(interval(25), (Ends{8.0, 18.0}));
}

// In 400 fleets of 20, intervals of 95.9 % miss the truth 16 times, with a standard deviation of 4. The limit is 32.
TEST(Distributions, TheIntervalOfTheMedianCoversWhatItSays) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal(0.05, 0.04);
  int missed = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<double> values(20);
    for (double& value : values) {
      value = normal(generator);
    }
    const auto interval = campaign::distributionOf(values).at("median_interval_95").get<Ends>();
    missed += interval[0] > 0.05 || interval[1] < 0.05 ? 1 : 0;
  }
  EXPECT_LE(missed, 32);
  EXPECT_GE(missed, 1);
}

TEST(FleetAnalysis, SharesHaveIntervalsAndComeByFrequency) {
  std::vector<campaign::Record> records(6, diagnosis(diagnosis::Verdict::none));
  records.insert(records.end(), 3, diagnosis(diagnosis::Verdict::named, {"friction"}));
  records.push_back(diagnosis(diagnosis::Verdict::named, {"friction", "creep"}));
  const Json type = analyse(records);
  const Json& effects = type.at("effects");
  ASSERT_THAT(effects, SizeIs(2));
  EXPECT_EQ(effects[0].at("name"), "friction");
  EXPECT_EQ(effects[0].at("components"), 4U);
  EXPECT_DOUBLE_EQ(effects[0].at("share"), 0.4);
  // Jeffreys' interval for 4 of 10 has quantiles of a Beta(4.5, 6.5) distribution, from numerical integration.
  EXPECT_NEAR(effects[0].at("interval_95")[0].get<double>(), 0.153, 0.001);
  EXPECT_NEAR(effects[0].at("interval_95")[1].get<double>(), 0.696, 0.001);
  EXPECT_EQ(effects[1].at("name"), "creep");
  ASSERT_THAT(type.at("verdicts"), SizeIs(2));
  EXPECT_EQ(type.at("verdicts")[0].at("name"), "none");
  EXPECT_DOUBLE_EQ(type.at("verdicts")[0].at("share"), 0.6);
}

TEST(FleetAnalysis, EstimatesHaveNoVerdict) {
  campaign::Record record;
  record.findings.changes["spring_1.stiffness"] = 0.1;
  const Json type = analyse({record});
  EXPECT_THAT(type.at("verdicts"), IsEmpty());
  EXPECT_DOUBLE_EQ(type.at("parameters").at(0).at("median"), 0.1);
}

TEST(FleetAnalysis, TellsWrongValuesOfTheTypeFromScatterBetweenTestPieces) {
  const Json common = analyse(scatteringFleet(-0.1, 0.03)).at("parameters").at(0);
  // The standard error of the median of 30 values is 1.25 times 0.03/sqrt(30), and 1.36 times for a quartile.
  EXPECT_NEAR(common.at("median").get<double>(), -0.1, 4.0 * 1.25 * 0.03 / std::sqrt(30.0));
  EXPECT_LT(common.at("median_interval_95")[1].get<double>(), 0.0);
  EXPECT_NEAR(common.at("quartiles")[1].get<double>(), -0.1 + 0.6745 * 0.03, 4.0 * 1.36 * 0.03 / std::sqrt(30.0));
  const Json scatter = analyse(scatteringFleet(0.0, 0.05)).at("parameters").at(0).at("median_interval_95");
  EXPECT_LT(scatter[0].get<double>(), 0.0);
  EXPECT_GT(scatter[1].get<double>(), 0.0);
}

TEST(FleetAnalysis, FindsTheComponentsThatAreFarOut) {
  std::vector<campaign::Record> records = scatteringFleet(0.0, 0.03);
  records[4] = withChange(std::log(1.8));
  records[9] = withChange(-0.4);
  EXPECT_THAT(farOut(analyse(records)), ::testing::ElementsAre("truck_4 bush", "truck_9 bush"));
}

// The limit of six standard deviations uses quartiles, which scatter in small fleets. In 8000 other draws, 4.0 % of
// fleets of 6 had an outlier, 0.4 % of fleets of 20, and none of 100. The limits are four deviations above.
TEST(FleetAnalysis, RarelyTakesChanceForAComponentThatIsFarOut) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.05, 0.04);
  for (const auto& [components, most] : std::map<std::size_t, int>{{6, 32}, {20, 7}, {100, 1}}) {
    int alarms = 0;
    for (int i = 0; i < 400; ++i) {
      std::vector<campaign::Record> records;
      for (std::size_t k = 0; k < components; ++k) {
        records.push_back(withChange(normal(generator)));
      }
      alarms += farOut(analyse(records)).empty() ? 0 : 1;
    }
    EXPECT_LE(alarms, most) << components;
  }
}

TEST(FleetAnalysis, OfAFewComponentsNoneIsFarOut) {
  std::vector<campaign::Record> records = scatteringFleet(0.0, 0.01, 5);
  records[3] = withChange(1.0);
  EXPECT_THAT(farOut(analyse(records)), IsEmpty());
}

TEST(FleetAnalysis, SaysNothingOfWhatABenchCannotHold) {
  std::vector<campaign::Record> records = scatteringFleet(0.004, 1e-4);
  records[5] = withChange(0.014);  // far beyond a scatter of 0.01 %
  EXPECT_THAT(farOut(analyse(records)), IsEmpty());
}

TEST(FleetAnalysis, EqualValuesAreADistribution) {
  const Json type = analyse(std::vector<campaign::Record>(9, withChange(0.5)));
  EXPECT_EQ(type.at("parameters").at(0).at("quartiles")[0], 0.5);
  EXPECT_THAT(farOut(type), IsEmpty());
}

TEST(FleetAnalysis, FailedJobsAndReplaysAddNothing) {
  campaign::Fleet fleet;
  campaign::Job replay = job(1);
  replay.command = campaign::Command::replay;
  fleet.add(replay, withChange(0.1));
  campaign::Record failed = withChange(0.1);
  failed.error = "no log";
  fleet.add(job(2), failed);
  EXPECT_THAT(fleet.analyse().at("types"), IsEmpty());
}

TEST(FleetAnalysis, TypesAreComparedEachAlone) {
  campaign::Fleet fleet;
  fleet.add(job(1, "bush"), diagnosis(diagnosis::Verdict::none));
  fleet.add(job(2, "mount"), diagnosis(diagnosis::Verdict::none));
  EXPECT_THAT(fleet.analyse().at("types"), SizeIs(2));
}

// Returns three types with different stiffness, twelve components each. The rig adds `taken` to a change of stiffness.
campaign::Fleet fleetOnRig(const std::function<double(double)>& taken, const std::vector<std::string>& rigs) {
  std::mt19937 generator(8);
  std::normal_distribution<double> normal;
  campaign::Fleet fleet;
  int number = 0;
  for (const double stiffness : {1e6, 2.2e6, 5e6}) {
    const std::string rig = rigs[static_cast<std::size_t>(number / 12) % rigs.size()];
    for (int i = 0; i < 12; ++i) {
      campaign::Job one = job(number++, fmt::format("type of {:g}", stiffness));
      one.test_rig = rig;
      campaign::Record record = diagnosis(diagnosis::Verdict::parameter_error);
      const double hardness = 0.03 * normal(generator);
      record.findings.changes["static_stiffness"] = hardness + 0.01 * normal(generator) + taken(stiffness);
      record.findings.changes["dynamic_stiffness"] = hardness + 0.01 * normal(generator) + taken(1.4 * stiffness);
      fleet.add(one, record);
    }
  }
  return fleet;
}

double softly(double stiffness) { return -std::log1p(2.5e-8 * stiffness); }

double medianOn(const Json& findings, const std::string& rig, const std::string& type) {
  for (const Json& row : findings.at("rigs")) {
    if (row.at("name") == rig && row.at("type") == type && row.at("parameter") == "static_stiffness") {
      EXPECT_EQ(row.at("components"), 12U);
      return row.at("median");
    }
  }
  ADD_FAILURE() << "no median of " << type << " on " << rig;
  return 0.0;
}

TEST(FleetAnalysis, MediansByRigShowOneThatGivesWay) {
  const Json findings = fleetOnRig(softly, {"hexapod"}).analyse();
  EXPECT_THAT(findings.at("rigs"), SizeIs(6));  // three types, each with two stiffnesses
  for (const double stiffness : {1e6, 2.2e6, 5e6}) {
    // The standard error of the median of 12 is 1.25 times 0.03/sqrt(12). The limit is three standard errors.
    EXPECT_NEAR(medianOn(findings, "hexapod", fmt::format("type of {:g}", stiffness)), softly(stiffness), 0.033);
  }
}

TEST(FleetAnalysis, RigsOfOneTypeHaveNothingToCompare) {
  EXPECT_THAT(fleetOnRig(softly, {"a", "b", "c"}).analyse().at("rigs"), IsEmpty());
}

TEST(FleetFile, HoldsWhatTheReportShows) {
  const auto json = nlohmann::json::parse(campaign::toJson(fleetOnRig(softly, {"hexapod"}), {}));
  EXPECT_EQ(json.at("schema"), "rubber_suspension/fleet/3");
  ASSERT_EQ(json.at("types").size(), 3U);
  EXPECT_EQ(json.at("rigs")[0].at("name"), "hexapod");
  const auto& stiff = json.at("types")[2];
  EXPECT_EQ(stiff.at("verdicts")[0].at("name"), "parameter_error");
  EXPECT_LT(stiff.at("parameters")[0].at("median_interval_95")[1].get<double>(), 0.0);
  EXPECT_EQ(stiff.at("parameters")[0].at("quartiles").size(), 2U);
  std::vector<campaign::Record> records = scatteringFleet(0.0, 0.03);
  records[4] = withChange(std::log(1.8));
  const Json far_out = analyse(records).at("far_out");
  ASSERT_EQ(far_out.size(), 1U);
  EXPECT_EQ(far_out[0].at("component"), "truck_4 bush");
  EXPECT_EQ(far_out[0].at("id"), job(4).id);
}

TEST(FleetFile, ListsComponentsWithTheirReports) {
  campaign::Fleet fleet;
  campaign::Job one = job(1);
  one.test_piece = "<script>";
  campaign::Record record = diagnosis(diagnosis::Verdict::named, {"friction"});
  record.id = one.id;
  record.files["report.html"] = {};
  fleet.add(one, record);
  campaign::CollectSummary summary;
  summary.done = 1;
  summary.failed = 2;
  summary.missing = 3;
  const auto json = nlohmann::json::parse(campaign::toJson(fleet, summary));
  EXPECT_EQ(json.at("jobs").dump(), R"({"done":1,"failed":2,"missing":3})");
  const auto& listed = json.at("types")[0].at("listed")[0];
  EXPECT_THAT(listed.at("component").get<std::string>(), HasSubstr("<script>"));
  EXPECT_EQ(listed.at("report"), "reports/00/" + one.id.substr(2) + "/report.html");
  EXPECT_EQ(listed.at("verdict"), "named");
  EXPECT_EQ(listed.at("effects").dump(), R"(["friction"])");
}

}  // namespace
}  // namespace rubber_suspension
