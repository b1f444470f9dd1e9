// Logs from MATLAB files of all levels. SciPy wrote the files in mat_logs/, except that libmatio wrote level 7.3. All
// good files contain time 0, 0.5, 1, 1.5, 2 s, displacement 0, 1, 2, 1, 0 mm and force 0, 3, 6.5, 2.5, -0.5 kN.
#include "rubber_suspension/log/log.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

log::Log read(const std::string& name, const log::LogFormat& format = {}) {
  return log::readLog(TEST_DIR "/log/mat_logs/" + name + ".mat", format);
}

std::string errorOf(const std::string& name, const log::LogFormat& format = {}) {
  return messageOf<log::LogError>([&] { read(name, format); });
}

class MatLogOfLevel : public ::testing::TestWithParam<const char*> {};

TEST_P(MatLogOfLevel, HasTheColumnsOfACsvLog) {
  const log::Log log = read(GetParam());
  EXPECT_EQ(log.name, GetParam());
  EXPECT_THAT(log.stamp, ElementsAre(0, 500000000, 1000000000, 1500000000, 2000000000));
  EXPECT_THAT(log.displacement, ElementsAre(0.0, 0.001, 0.002, 0.001, 0.0));
  EXPECT_THAT(log.force, ElementsAre(0.0, 3000.0, 6500.0, 2500.0, -500.0));
}

INSTANTIATE_TEST_SUITE_P(Levels, MatLogOfLevel, ::testing::Values("level4", "columns", "level73"));

TEST(MatLog, NotesWhatItIgnores) {
  EXPECT_THAT(read("columns").notes, ElementsAre("column 'gain' is ignored"));  // text is not a column
}

// The file contains a struct with a displacement in single precision [cm] and a time in whole seconds.
TEST(MatLog, FieldsOfAStructWithMapping) {
  const log::LogFormat format =
      log::makeLogFormat({"time=time", "displacement=disp", "force=force"}, "displacement=cm force=N", 0.0);
  const log::Log log = read("struct", format);
  EXPECT_THAT(log.stamp, ElementsAre(0, 1000000000, 2000000000, 3000000000, 4000000000));
  EXPECT_THAT(log.displacement, ElementsAre(0.0, 0.01, 0.02, 0.01, 0.0));
  EXPECT_THAT(log.force, ElementsAre(0.0, 3.0, 6.5, 2.5, -0.5));
}

TEST(MatLog, ARateStandsForTime) {
  EXPECT_THAT(read("no_time", log::makeLogFormat({}, "", 1000.0)).stamp,
              ElementsAre(0, 1000000, 2000000, 3000000, 4000000));
}

TEST(MatLog, LeavesOutWhatWasNotMeasured) {
  const log::Log log = read("not_finite");
  EXPECT_EQ(log.size(), 4U);
  EXPECT_THAT(log.notes, ElementsAre(HasSubstr(
                             "in only 4 of 5 rows (the first row without a value is element 2: displacement_mm: nan is "
                             "not finite)")));
}

TEST(MatLog, RefusesWhatCannotBeUsed) {
  EXPECT_THAT(errorOf("complex"), HasSubstr("displacement_mm: complex numbers; accepted: real numbers"));
  EXPECT_THAT(errorOf("time_repeats"), HasSubstr("element 3: time_s: the time 1.000000000 follows 1.000000000"));
  EXPECT_THAT(errorOf("lengths_differ"),
              HasSubstr("time_s has 5 values, displacement_mm has 4; accepted: equal numbers"));
  EXPECT_THAT(errorOf("matrix"), HasSubstr("there is no column of displacement; the header has 'time_s'"));
  EXPECT_THAT(errorOf("no_time"), HasSubstr("there is no column of time; the header has"));
  EXPECT_THAT(errorOf("cut_off"), HasSubstr("cut_off.mat: "));
  EXPECT_THAT(errorOf("text"), HasSubstr("damaged at byte 0: no header of a matrix; accepted: a complete MATLAB file"));
  EXPECT_THAT(errorOf("not_there"), HasSubstr("cannot be read: No such file or directory"));
}

}  // namespace
}  // namespace rubber_suspension
