// What the fleet decides, changes and leaves open, on fleets of known truth.
#include "campaign/fleet.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "campaign/fleet_report.h"
#include "campaign/record.h"

namespace rubber_suspension {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

campaign::Job job(int number, const std::string& type = "bush") {
  campaign::Job job;
  job.id = std::string(64 - std::to_string(number).size(), '0') + std::to_string(number);
  job.type = type;
  job.component = "bush";
  job.test_piece = "truck_" + std::to_string(number);
  return job;
}

// A diagnosis with one parameter ratio, by logs that scatter about it.
campaign::Record diagnosis(const std::string& verdict, const std::vector<std::string>& set = {},
                           const std::map<std::string, double>& probabilities = {}, double ratio = 1.0,
                           double scatter_of_logs = 0.01) {
  campaign::Record record;
  const std::vector<std::string> effects = set.empty() ? set : std::vector<std::string>{set.front()};
  nlohmann::ordered_json by_log = nlohmann::ordered_json::array();
  for (const double sign : {-1.0, 0.0, 1.0}) {
    by_log.push_back({{"static_stiffness", ratio * std::exp(sign * scatter_of_logs)}});
  }
  nlohmann::ordered_json explanations = nlohmann::ordered_json::array();
  for (const std::string& cause : set) {
    const auto probability = probabilities.find(cause);
    explanations.push_back(
        {{"effects", cause == "parameter_error" ? std::vector<std::string>{} : std::vector<std::string>{cause}},
         {"probability", probability == probabilities.end() ? 0.0 : probability->second}});
  }
  if (set.empty() && verdict != "unknown") {
    explanations.push_back({{"effects", nlohmann::ordered_json::array()}, {"probability", 0.99}});
  }
  record.evidence = {{"verdict", verdict},
                     {"effects", effects},
                     {"explanations", explanations},
                     {"ratios", {{"static_stiffness", ratio}}},
                     {"ratios_by_log", by_log}};
  return record;
}

campaign::FleetType analyse(const std::vector<campaign::Record>& records) {
  campaign::Fleet fleet;
  for (std::size_t i = 0; i < records.size(); ++i) {
    fleet.add(job(static_cast<int>(i)), records[i]);
  }
  return fleet.analyse().types.at(0);
}

TEST(FleetAnalysis, DecidesBetweenEffectsThatOneComponentConfounds) {
  std::vector<campaign::Record> records(20, diagnosis("named", {"friction"}, {{"friction", 0.99}}));
  records.push_back(diagnosis("confounded", {"relaxation", "friction"}, {{"relaxation", 0.55}, {"friction", 0.45}}));
  const campaign::FleetType type = analyse(records);
  ASSERT_THAT(type.changed, SizeIs(1));
  EXPECT_EQ(type.changed[0].component, 20U);
  EXPECT_EQ(type.changed[0].to, "named: friction");
  // By hand: 0.45 (20 + 1/2) against 0.55 (0 + 1/2): 0.971.
  EXPECT_THAT(type.changed[0].reason, AllOf(HasSubstr("of 20 components"), HasSubstr("97 % within the set")));
}

TEST(FleetAnalysis, LeavesWhatEveryComponentConfounds) {
  // Thirty components that all lean the same way are no thirty witnesses.
  EXPECT_THAT(analyse(std::vector<campaign::Record>(
                          30, diagnosis("confounded", {"relaxation", "creep"}, {{"relaxation", 0.6}, {"creep", 0.4}})))
                  .changed,
              IsEmpty());
}

TEST(FleetAnalysis, LeavesWhatADividedFleetDoesNotDecide) {
  std::vector<campaign::Record> records(10, diagnosis("named", {"friction"}, {{"friction", 0.99}}));
  records.insert(records.end(), 10, diagnosis("named", {"relaxation"}, {{"relaxation", 0.99}}));
  records.push_back(diagnosis("confounded", {"relaxation", "friction"}, {{"relaxation", 0.55}, {"friction", 0.45}}));
  EXPECT_THAT(analyse(records).changed, IsEmpty());
}

TEST(FleetAnalysis, DoesNotBringBackWhatAComponentExcludes) {
  std::vector<campaign::Record> records(50, diagnosis("named", {"friction"}, {{"friction", 0.99}}));
  records.push_back(diagnosis("confounded", {"creep", "relaxation"}, {{"creep", 0.6}, {"relaxation", 0.39}}));
  EXPECT_THAT(analyse(records).changed, IsEmpty());
}

std::vector<campaign::Record> scatteringFleet(double mean, double scatter, std::size_t components = 30) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(mean, scatter);
  std::vector<campaign::Record> records;
  for (std::size_t i = 0; i < components; ++i) {
    records.push_back(diagnosis("parameter_error", {}, {}, std::exp(normal(generator))));
  }
  return records;
}

TEST(FleetAnalysis, TellsWrongValuesOfTheTypeFromScatterBetweenTestPieces) {
  const campaign::FleetType common = analyse(scatteringFleet(-0.1, 0.03));
  ASSERT_TRUE(common.parameters.at(0).model);
  EXPECT_TRUE(common.parameters[0].wrong_for_all);
  EXPECT_NEAR(common.parameters[0].model->mean, -0.1, 4.0 * 0.03 / std::sqrt(30.0));
  // The scatter itself is known to 1/sqrt(2*29) of it.
  EXPECT_NEAR(common.parameters[0].model->scatter, 0.03, 4.0 * 0.03 / std::sqrt(58.0));
  ASSERT_THAT(common.changed, SizeIs(30));
  EXPECT_EQ(common.changed[0].to, "wrong values common to the type");
  EXPECT_THAT(common.changed[0].reason, HasSubstr("static_stiffness -"));

  const campaign::FleetType scatter = analyse(scatteringFleet(0.0, 0.05));
  EXPECT_FALSE(scatter.parameters[0].wrong_for_all);
  ASSERT_THAT(scatter.changed, SizeIs(30));
  EXPECT_EQ(scatter.changed[0].to, "scatter between test pieces");
}

TEST(FleetAnalysis, AComponentThatStandsOutKeepsItsVerdict) {
  std::vector<campaign::Record> records = scatteringFleet(0.0, 0.03);
  records[4] = diagnosis("parameter_error", {}, {}, 1.8);
  const campaign::FleetType type = analyse(records);
  ASSERT_THAT(type.stand_outs, SizeIs(1));
  EXPECT_EQ(type.stand_outs[0].component, 4U);
  EXPECT_NEAR(type.stand_outs[0].ratio, 1.8, 1e-12);
  for (const campaign::ChangedVerdict& changed : type.changed) {
    EXPECT_NE(changed.component, 4U);
  }
}

TEST(FleetAnalysis, AFewComponentsDecideNothing) {
  EXPECT_THAT(analyse(scatteringFleet(-0.2, 0.01, 4)).changed, IsEmpty());
}

// Three types of different stiffness, of twelve components each, whose rig takes `taken` of a stiffness [N/m].
campaign::Fleet fleetOnRig(const std::function<double(double)>& taken, const std::vector<std::string>& rigs,
                           const campaign::Record& like) {
  std::mt19937 generator(8);
  std::normal_distribution<double> normal;
  campaign::Fleet fleet;
  int number = 0;
  for (const double stiffness : {1e6, 2.2e6, 5e6}) {
    const std::string rig = rigs[static_cast<std::size_t>(number / 12) % rigs.size()];
    for (int i = 0; i < 12; ++i) {
      campaign::Job one = job(number++, fmt::format("type of {:g}", stiffness));
      one.test_rig = rig;
      campaign::Record record = like;
      const double hardness = 0.03 * normal(generator);
      for (const auto& [name, factor] :
           std::map<std::string, double>{{"static_stiffness", 1.0}, {"dynamic_stiffness", 1.4}}) {
        record.evidence["ratios"][name] = std::exp(hardness + 0.01 * normal(generator) + taken(stiffness * factor));
      }
      fleet.add(one, record);
    }
  }
  return fleet;
}

double softly(double stiffness) { return -std::log1p(2.5e-8 * stiffness); }

double meanOn(const campaign::FleetFindings& findings, const std::string& rig, const std::string& type) {
  for (const campaign::RigMean& row : findings.rigs) {
    if (row.rig == rig && row.type == type && row.parameter == "static_stiffness") {
      EXPECT_EQ(row.components, 12U);
      return row.mean;
    }
  }
  ADD_FAILURE() << "no mean of " << type << " on " << rig;
  return 0.0;
}

TEST(FleetAnalysis, MeansByRigShowOneThatGivesWay) {
  const campaign::FleetFindings findings = fleetOnRig(softly, {"hexapod"}, diagnosis("parameter_error")).analyse();
  EXPECT_THAT(findings.rigs, SizeIs(6));  // three types of two stiffnesses
  for (const double stiffness : {1e6, 2.2e6, 5e6}) {
    // The mean of twelve is known to 0.03/sqrt(12): three times that.
    EXPECT_NEAR(meanOn(findings, "hexapod", fmt::format("type of {:g}", stiffness)), softly(stiffness), 0.026);
  }
  for (const campaign::FleetType& type : findings.types) {
    for (const campaign::ChangedVerdict& one : type.changed) {
      EXPECT_THAT(one.reason, HasSubstr("or the rig"));
    }
  }
}

TEST(FleetAnalysis, RigsOfOneTypeHaveNothingToCompare) {
  const campaign::FleetFindings findings = fleetOnRig(softly, {"a", "b", "c"}, diagnosis("parameter_error")).analyse();
  EXPECT_THAT(findings.rigs, IsEmpty());
  ASSERT_THAT(findings.types.at(2).changed, SizeIs(12));
  EXPECT_EQ(findings.types[2].changed[0].to, "wrong values common to the type");
}

TEST(FleetAnalysis, ScatterIsNoGainOfARig) {
  std::vector<campaign::Record> records = scatteringFleet(0.0, 0.05);
  records[2] = diagnosis("confounded", {"sensor_gain", "parameter_error"}, {}, 1.04);
  const campaign::FleetType type = analyse(records);
  const auto changed = std::find_if(type.changed.begin(), type.changed.end(),
                                    [](const campaign::ChangedVerdict& one) { return one.component == 2; });
  ASSERT_NE(changed, type.changed.end());
  EXPECT_EQ(changed->to, "scatter between test pieces");
}

TEST(FleetAnalysis, OneTypeLeavesAGainBesideWrongValues) {
  std::vector<campaign::Record> records = scatteringFleet(-0.1, 0.02);
  records[2] = diagnosis("confounded", {"sensor_gain", "parameter_error"}, {}, std::exp(-0.1));
  const campaign::FleetType type = analyse(records);
  EXPECT_THAT(type.changed, SizeIs(29));
  for (const campaign::ChangedVerdict& one : type.changed) {
    EXPECT_NE(one.component, 2U);
  }
}

TEST(FleetAnalysis, CountsNoWitnessesAgainstACompliance) {
  // Re-estimation hides it in all of them: forty that call it wrong values say nothing of the one that does not.
  std::vector<campaign::Record> records(40, diagnosis("parameter_error", {}, {}, 0.9));
  records.push_back(diagnosis("confounded", {"series_compliance", "parameter_error"},
                              {{"series_compliance", 0.5}, {"parameter_error", 0.5}}, 0.9));
  for (const campaign::ChangedVerdict& changed : analyse(records).changed) {
    EXPECT_NE(changed.component, 40U);
  }
}

TEST(FleetAnalysis, ComponentsWithAnEffectTakeNoPartInTheValues) {
  // Re-estimation without its effect would bend them far.
  std::vector<campaign::Record> records = scatteringFleet(0.0, 0.03);
  records[3] = diagnosis("named", {"friction"}, {{"friction", 0.99}}, 1.4);
  records[9] = diagnosis("unknown", {}, {}, 0.6);
  const campaign::FleetType type = analyse(records);
  EXPECT_THAT(type.stand_outs, IsEmpty());
  EXPECT_THAT(type.parameters.at(0).components, SizeIs(28));
}

TEST(FleetAnalysis, SaysNothingOfWhatABenchCannotHold) {
  // 0.4 % in all components, and 1 % in one, far beyond a scatter of 0.01 %.
  std::vector<campaign::Record> records = scatteringFleet(0.004, 1e-4);
  records[5] = diagnosis("parameter_error", {}, {}, 1.014, 1e-4);
  const campaign::FleetType type = analyse(records);
  EXPECT_FALSE(type.parameters.at(0).wrong_for_all);
  EXPECT_THAT(type.stand_outs, IsEmpty());
}

TEST(FleetFile, HoldsWhatTheReportShows) {
  const auto json =
      nlohmann::json::parse(campaign::toJson(fleetOnRig(softly, {"hexapod"}, diagnosis("parameter_error")).analyse()));
  EXPECT_EQ(json.at("schema"), "rubber_suspension/fleet/2");
  EXPECT_EQ(json.at("types").size(), 3U);
  EXPECT_EQ(json.at("types")[0].at("changed").size(), 12U);
  EXPECT_EQ(json.at("rigs")[0].at("name"), "hexapod");
  EXPECT_LT(json.at("types")[0].at("parameters")[0].at("mean_interval_95")[0].get<double>(), 0.0);
}

TEST(FleetAnalysis, TypesAreComparedEachAlone) {
  campaign::Fleet fleet;
  fleet.add(job(1, "bush"), diagnosis("none"));
  fleet.add(job(2, "mount"), diagnosis("none"));
  EXPECT_THAT(fleet.analyse().types, SizeIs(2));
}

TEST(FleetReport, EscapesNamesAndLinksReports) {
  campaign::Fleet fleet;
  campaign::Job one = job(1);
  one.test_piece = "<script>";
  campaign::Record record = diagnosis("named", {"friction"}, {{"friction", 0.99}});
  record.id = one.id;
  record.files["report.html"] = 1;
  fleet.add(one, record);
  const std::string html = campaign::fleetHtml(fleet.analyse(), {});
  EXPECT_THAT(html, AllOf(HasSubstr("&lt;script&gt;"), ::testing::Not(HasSubstr("<script"))));
  EXPECT_THAT(html, HasSubstr("<a href=\"reports/00/" + one.id.substr(2) + "/report.html\">"));
}

}  // namespace
}  // namespace rubber_suspension
