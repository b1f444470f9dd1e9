// Comparison of two reports: it lists changes beyond noise and intervals, and refuses files that are not reports.
#include "diagnosis/report/compare.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

diagnosis::Diagnosis firstDay() {
  diagnosis::Diagnosis d;
  d.component = "bush";
  d.answer.verdict = diagnosis::Verdict::named;
  d.answer.effects = {"friction"};
  d.gaps.unseen = {0.14, 0.12, 0.02, 0.01};
  d.law.model_sizes = {{"specification", "dynamic_stiffness", "N/m", 4e6, 4.2e6, {4.1e6, 4.3e6}}};
  d.law.effect_sizes = {{"friction", "maximum_force", "N", 0.0, 6000.0, {5800.0, 6200.0}}};
  d.where.before = {{"monday", {2.0, 4.0}, {2e-4, 5e-4}, gap::Quantity::loss, 1.0, 10.0}};
  d.rig_findings.push_back({"monday", "force_zero", 31.0, {29.0, 33.0}, "N", false, false, ""});
  d.run.version = "1";
  d.run.date = "2026-01-01T00:00:00Z";
  return d;
}

class Compare : public testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(path_) << text; }

  diagnosis::Comparison since(const diagnosis::Diagnosis& before, const diagnosis::Diagnosis& now) const {
    write(diagnosis::toJson(before));
    return diagnosis::report::EarlierReport(path_).compare(now);
  }

  void TearDown() override { std::remove(path_.c_str()); }

  const std::string path_ = testing::TempDir() + "earlier_report.json";
};

const diagnosis::ReportChange& changeOf(const diagnosis::Comparison& comparison, const std::string& what) {
  const auto found = std::find_if(comparison.changes.begin(), comparison.changes.end(),
                                  [&](const auto& change) { return change.what == what; });
  return found != comparison.changes.end() ? *found : throw std::out_of_range(what);
}

TEST_F(Compare, FindsNothingBetweenEqualReports) {
  const diagnosis::Comparison comparison = since(firstDay(), firstDay());
  EXPECT_EQ(comparison.date, "2026-01-01T00:00:00Z");
  for (const diagnosis::ReportChange& change : comparison.changes) {
    EXPECT_FALSE(change.differs) << change.what;
    EXPECT_EQ(change.before, change.after) << change.what;
  }
  EXPECT_THAT(diagnosis::report::toText(comparison), HasSubstr("11 of 11 values have changed by no more than"));
}

TEST_F(Compare, TellsValuesApartByTheirIntervals) {
  diagnosis::Diagnosis now = firstDay();
  now.law.model_sizes[0].value = 4.25e6;  // within the earlier interval
  now.law.model_sizes[0].interval_95 = {4.2e6, 4.35e6};
  now.law.effect_sizes[0].value = 4000.0;
  now.law.effect_sizes[0].interval_95 = {3900.0, 4100.0};
  now.rig_findings.clear();
  const diagnosis::Comparison comparison = since(firstDay(), now);
  EXPECT_FALSE(changeOf(comparison, "K_n").differs);
  const diagnosis::ReportChange& force = changeOf(comparison, "friction maximum force");
  EXPECT_TRUE(force.differs);
  EXPECT_EQ(force.before, "6 kN (5.8 to 6.2 kN)");
  EXPECT_EQ(force.after, "4 kN (3.9 to 4.1 kN)");
  EXPECT_EQ(changeOf(comparison, "force zero of monday").after, "not found");
  const std::string text = diagnosis::report::toText(comparison);
  EXPECT_THAT(text, HasSubstr("friction maximum force: 6 kN (5.8 to 6.2 kN) -> 4 kN"));
  EXPECT_THAT(text, Not(HasSubstr("K_n")));
}

// Logs of another day have other names. So the comparison sums a cell of the map over all logs, as a share of the gap.
TEST_F(Compare, FollowsThePlacesOfTheGap) {
  diagnosis::Diagnosis now = firstDay();
  now.gaps.unseen.as_configured = 0.2;
  now.answer.verdict = diagnosis::Verdict::partly;
  now.where.before = {{"tuesday", {2.0, 4.0}, {2e-4, 5e-4}, gap::Quantity::loss, 0.49, 10.0},
                      {"tuesday", {4.0, 8.0}, {2e-4, 5e-4}, gap::Quantity::stiffness, 0.51, 10.0}};
  const diagnosis::Comparison comparison = since(firstDay(), now);
  EXPECT_TRUE(changeOf(comparison, "verdict").differs);
  const auto& same = changeOf(comparison, "gap in loss at 2 to 4 Hz, 0.2 to 0.5 mm");
  EXPECT_EQ(same.before, "14.0 %");
  EXPECT_EQ(same.after, "14.0 %");  // 0.2 sqrt(0.49)
  EXPECT_FALSE(same.differs);
  const auto& other = changeOf(comparison, "gap in stiffness at 4 to 8 Hz, 0.2 to 0.5 mm");
  EXPECT_EQ(other.before, "0.0 %");
  EXPECT_TRUE(other.differs);
}

TEST_F(Compare, RefusesWhatIsNoReport) {
  for (const char* text :
       {"", "[]", "{}", "{\"schema\": 1}", "{\"schema\": \"rubber_suspension/gap_report/2\"}", "{\"schema\"",
        "{\"schema\": \"rubber_suspension/gap_report/1\", \"component\": 3}",
        "{\"schema\": \"rubber_suspension/gap_report/1\", \"component\": \"a\", \"verdict\": \"none\", "
        "\"effects\": [], \"gap\": 0.1, \"where\": []}"}) {
    write(text);
    const std::string error = messageOf<std::runtime_error>([&] { diagnosis::report::EarlierReport report(path_); });
    EXPECT_THAT(error, testing::StartsWith(path_ + ": ")) << text;
    EXPECT_THAT(error, Not(HasSubstr("\n"))) << text;
  }
  std::remove(path_.c_str());
  EXPECT_THROW(diagnosis::report::EarlierReport{path_}, std::runtime_error) << "missing";
}

}  // namespace
}  // namespace rubber_suspension
