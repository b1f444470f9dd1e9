// Commands never overwrite an input, write each file once, and replace files of another kind only with --force.
#include "io/output_files.h"

#include "rubber_suspension/io/component_file.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

namespace fs = std::filesystem;

class CheckOutputs : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.folder() + "/" + name; }

  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  // Returns the refusal of outputs beside an input, or an empty string if they are accepted.
  static std::string refusal(const std::string& input, const std::vector<io::OutputFile>& outputs, bool force = false) {
    return messageOf<io::OutputRefused>([&] { io::checkOutputs({{"--log", input}}, outputs, force); });
  }

  TemporaryFile folder_{"log.csv", "time_s,displacement_m,force_N\n0,0,0\n"};
};

TEST_F(CheckOutputs, ALogCountsOnceByWhateverName) {
  const std::string log = file("a.csv", "time_s,displacement_m\n0,0\n1,1\n");
  const std::string copy = file("copy.csv", "time_s,displacement_m\n0,0\n1,1\n");
  const std::string other = file("other.csv", "time_s,displacement_m\n0,0\n1,2\n");
  fs::create_hard_link(log, path("link.csv"));
  fs::create_symlink(log, path("symbolic.csv"));
  for (const std::string& twin : {log, copy, path("link.csv"), path("symbolic.csv")}) {
    EXPECT_THROW(io::refuseEqualLogs({{"--log", log}, {"--log", other}, {"--hold-out", twin}}), io::OutputRefused)
        << twin;
  }
  EXPECT_NO_THROW(io::refuseEqualLogs({{"--log", log}, {"--hold-out", other}}));
  EXPECT_NO_THROW(io::refuseEqualLogs({{"--log", "/dev/null"}, {"--log", log}}));
}

TEST_F(CheckOutputs, RefusesAnInputByAnyName) {
  const std::string log = path("log.csv");
  fs::create_hard_link(log, path("hard.csv"));
  fs::create_symlink("log.csv", path("soft.csv"));
  fs::create_symlink(folder_.folder(), path("again"));
  for (const std::string& name :
       {std::string("log.csv"), std::string("./log.csv"), std::string("hard.csv"), std::string("soft.csv"),
        std::string("again/log.csv"), std::string("again/./log.csv")}) {
    const std::string error = refusal(log, {{"--output", path(name), io::file_kind::force_csv}}, true);
    EXPECT_THAT(error, HasSubstr("--output: ")) << name;
    EXPECT_THAT(error, HasSubstr("is also the input file of --log")) << name;
    EXPECT_THAT(error, HasSubstr("accepted: another file")) << name;
  }
  EXPECT_EQ(refusal(log, {{"--output", path("other.csv"), io::file_kind::force_csv}}), "");
  EXPECT_EQ(refusal(log, {{"--output", "", io::file_kind::force_csv}}), "");
}

TEST_F(CheckOutputs, RefusesTwoOutputsThatAreOneFile) {
  const auto both = [&](const std::string& one, const std::string& other) {
    return refusal("",
                   {{"--output", path(one), io::file_kind::figure}, {"--plot", path(other), io::file_kind::figure}});
  };
  EXPECT_THAT(both("a.svg", "a.svg"), HasSubstr("--plot and --output"));
  EXPECT_THAT(both("a.svg", "./x/../a.svg"), HasSubstr("the same file as"));
  EXPECT_THAT(both("a.svg", "A.SVG"), HasSubstr("the same file as"));  // the same file if the file system ignores case
  fs::create_symlink("a.svg", path("dangling.svg"));
  EXPECT_THAT(both("a.svg", "dangling.svg"), HasSubstr("the same file as"));
  EXPECT_EQ(both("a.svg", "b.svg"), "");
  file("b.svg", "<svg>");
  file("B.svg", "<svg>");
  if (!fs::equivalent(path("b.svg"), path("B.svg"))) {
    EXPECT_EQ(both("b.svg", "B.svg"), "");  // this file system distinguishes case
  }
  EXPECT_EQ(refusal("/dev/null",
                    {{"--output", "/dev/null", io::file_kind::bag}, {"--plot", "/dev/null", io::file_kind::bag}}),
            "");
}

TEST_F(CheckOutputs, AnotherKindOfFileNeedsForce) {
  const std::string notes = file("notes.txt", "what I did\n");
  const std::vector<io::OutputFile> output = {{"--output", notes, io::file_kind::force_csv}};
  EXPECT_THAT(refusal("", output), HasSubstr("notes.txt exists and is not a log as this command writes it"));
  EXPECT_THAT(refusal("", output), HasSubstr("or --force"));
  EXPECT_EQ(refusal("", output, true), "");
  file("notes.txt", "");
  EXPECT_EQ(refusal("", output), "");  // an empty file may be replaced
}

TEST_F(CheckOutputs, TellsTheKindsByTheirContent) {
  namespace kind = io::file_kind;
  const std::vector<std::pair<io::FileKind, std::string>> examples = {
      {kind::force_csv, "time_s,displacement_m,force_N\n0,0,0\n"},
      {kind::gap_csv, "time_s,level,window_s,samples\n"},
      {kind::vehicle_csv, "time_s,frame_m,pitch_rad\n"},
      {kind::figure_csv, "curve,frequency_hz\n"},
      {kind::force_map_csv, "displacement_m,velocity_m_per_s,missing_force_N\n"},
      {kind::characteristics_csv, "frequency_Hz,amplitude_m,stiffness_N_per_m\n"},
      {kind::campaign_csv, "id,group,type,test_piece\n"},
      {kind::campaign_json, "{\"schema\": \"rubber_suspension/campaign_table/1\",\n\"jobs\": []}"},
      {kind::campaign_manifest, "{\"schema\":\"rubber_suspension/campaign/1\"}\n"},
      {kind::fleet_json, "{\n \"schema\": \"rubber_suspension/fleet/1\"}"},
      {kind::fleet_report, "<!DOCTYPE html>\n<title>Fleet report</title>"},
      {kind::report_json, "{\n \"schema\": \"rubber_suspension/gap_report/1\"}"},
      {kind::report_html, "<!DOCTYPE html>\n<title>Gap report</title> the gap"},
      {kind::plan_json, "{\n \"schema\": \"rubber_suspension/experiment_plan/1\"}"},
      {kind::plan_html, "<!DOCTYPE html>\n<title>Experiment plan: a</title>"},
      {kind::agreement_json, "{\n \"schema\": \"rubber_suspension/agreement/1\"}"},
      {kind::state_space_json, "{\n \"schema\": \"rubber_suspension/state_space/1\"}"},
      {kind::mat, "rubber_suspension   \x01IM"},
      {kind::component_file, "# found by estimate\ncomponents:\n  a: {}\n"},
      {kind::spring_and_dashpot, "# bush\nk_N_per_m: 1e6\n"},
      {kind::bushing_file, "$---MDI_HEADER\n[MDI_HEADER]\nFILE_TYPE = 'bus'\n"},
      {kind::test_report, "<?xml version=\"1.0\"?>\n<testsuites/>"},
      {kind::figure, "<?xml version=\"1.0\"?>\n<svg/>"},
      {kind::bag, "#ROSBAG V2.0\n"},
      {kind::fmu, "PK\x03\x04 modelDescription.xml"},
      {kind::rpc, std::string("FORMAT\0\0\0", 9)},
  };
  for (std::size_t i = 0; i < examples.size(); ++i) {
    const std::string path = file("example", examples[i].second);
    for (std::size_t j = 0; j < examples.size(); ++j) {
      EXPECT_EQ(io::isOfKind(path, examples[j].first), i == j)
          << examples[i].second << " as " << examples[j].first.name;
    }
  }
  EXPECT_TRUE(io::isOfKind(file("example", "\x89PNG\r\n\x1a\n"), io::file_kind::figure));
  // A log with an additional column is a measurement, not an output of the command.
  EXPECT_FALSE(io::isOfKind(file("example", "time_s,displacement_mm,force_kN\n"), io::file_kind::force_csv));
  EXPECT_FALSE(io::isOfKind(file("example", "my components: a, b\n"), io::file_kind::component_file));
}

TEST_F(CheckOutputs, RefusesFoldersAsFilesAndFilesAsFolders) {
  EXPECT_THAT(refusal("", {{"--output", folder_.folder(), io::file_kind::bag}}, true), HasSubstr("is a folder"));
  EXPECT_THAT(refusal("", {{"--output", path("log.csv/report.json"), io::file_kind::report_json}}, true),
              HasSubstr("is not a folder"));
}

TEST_F(CheckOutputs, AnErrorIsOneLine) {
  const std::string odd = file("a\n\x1b[31m.txt", "text");
  const std::string error = refusal("", {{"--output", odd, io::file_kind::bag}});
  EXPECT_THAT(error, HasSubstr("\\x1b[31m"));
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

TEST(MakeRunFolder, NumbersTheRuns) {
  const TemporaryFile file("keep", "");
  const std::vector<std::string> records = {"bush_force.csv", "bush.bag"};
  const auto run = [&](const std::string& name) {
    const std::string folder = io::makeRunFolder(file.folder() + "/" + name, records);
    std::ofstream(folder + "/bush.bag") << "record";
    return fs::path(folder).filename().string();
  };
  EXPECT_EQ(run("run_1"), "run_1");
  EXPECT_EQ(run("run_1"), "run_2");
  EXPECT_EQ(run("run_1/"), "run_3");
  EXPECT_EQ(run("bench"), "bench");
  EXPECT_EQ(run("bench"), "bench_2");
  EXPECT_EQ(run("bench"), "bench_3");
  EXPECT_EQ(run("run_x"), "run_x");
  EXPECT_EQ(run("run_x"), "run_x_2");
}

TEST(MakeRunFolder, LeavesARunThatIsStillBeingWritten) {
  const TemporaryFile file(".bush_force.Ab12Cd.csv", "");
  EXPECT_EQ(io::makeRunFolder(file.folder(), {"bush_force.csv"}), file.folder() + "_2");
  fs::remove_all(file.folder() + "_2");
  EXPECT_EQ(io::makeRunFolder(file.folder(), {"left_force.csv"}), file.folder());  // another component's
}

}  // namespace
}  // namespace rubber_suspension
