// Reading and writing of CSV logs: what is accepted, to the last bit, and what is refused with line and reason.
#include "rubber_suspension/log/log.h"

#include <gmock/gmock.h>
#include <time.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>

#include "io/temporary_file.h"
#include "support/measured_data.h"
#include "support/message_of.h"

namespace rubber_suspension {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

log::Log readText(const std::string& text, const log::LogFormat& format = {}) {
  const TemporaryFile file("log.csv", text);
  return log::readCsvLog(file.path(), format);
}

std::string errorOf(const std::string& text, const log::LogFormat& format = {}) {
  return messageOf<log::LogError>([&] { readText(text, format); });
}

TEST(ReadCsvLog, ConvertsTheUnitsInColumnNames) {
  const log::Log log = readText("time_s,displacement_mm,force_kN,temperature_degC\n0,38,1.5,20\n0.001,-0.1,-2,20.5\n");
  EXPECT_EQ(log.name, "log");
  EXPECT_THAT(log.stamp, ElementsAre(0, 1000000));
  EXPECT_THAT(log.displacement, ElementsAre(0.038, -0.0001));
  EXPECT_THAT(log.force, ElementsAre(1500.0, -2000.0));
  EXPECT_THAT(log.temperature, ElementsAre(20.0, 20.5));
  EXPECT_TRUE(log.notes.empty());
}

TEST(ReadCsvLog, TakesColumnsInAnyOrderAndNotesThoseThatItIgnores) {
  const log::Log log = readText("force_MN,cycle,displacement_um,time_s\n0.001,1,2000,0\n0.002,1,-3000,0.5\n");
  EXPECT_THAT(log.displacement, ElementsAre(0.002, -0.003));
  EXPECT_THAT(log.force, ElementsAre(1000.0, 2000.0));
  EXPECT_THAT(log.notes, ElementsAre("column 'cycle' is ignored"));
}

TEST(ReadCsvLog, ForceMayBeMissing) {
  const log::Log log = readText("time_s,displacement_m\n0,0\n1,1\n");
  EXPECT_EQ(log.size(), 2u);
  EXPECT_TRUE(log.force.empty());
  EXPECT_TRUE(log.temperature.empty());
}

TEST(ReadCsvLog, AcceptsCarriageReturnsByteOrderMarkQuotedNamesBlanksAndBlankEnd) {
  const log::Log log = readText("\xEF\xBB\xBF\"time_s\", \"displacement_m\"\r\n0, 0.5\r\n1 ,\t-0.5 \r\n\r\n\n");
  EXPECT_THAT(log.stamp, ElementsAre(0, 1000000000));
  EXPECT_THAT(log.displacement, ElementsAre(0.5, -0.5));
}

TEST(ReadCsvLog, NotesALastLineWithoutEnd) {
  const log::Log log = readText("time_s,displacement_m\n0,0\n1,0.25");
  EXPECT_THAT(log.displacement, ElementsAre(0.0, 0.25));
  EXPECT_THAT(log.notes, ElementsAre("line 3, the last, has no line end: it may have been cut off"));
}

TEST(ReadCsvLog, TimeIsTheNearestNanosecond) {
  // The last is a time since 1970: a double would be off by up to 119 ns.
  const log::Log log =
      readText("time_s,displacement_m\n-0.5,0\n0.0000000014,0\n3.3333333335,0\n1732190400.123456789,0\n");
  EXPECT_THAT(log.stamp, ElementsAre(-500000000, 1, 3333333334, 1732190400123456789));
}

TEST(ReadCsvLog, DoesNotDependOnTheLocale) {
  const char* const previous = std::setlocale(LC_ALL, nullptr);
  const std::string saved = previous;
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) {
    GTEST_SKIP() << "the locale de_DE.UTF-8 is not installed";
  }
  const log::Log log = readText("time_s,displacement_m\n0,0.5\n0.5,1.5\n");
  std::setlocale(LC_ALL, saved.c_str());
  EXPECT_THAT(log.displacement, ElementsAre(0.5, 1.5));
}

TEST(ReadCsvLog, MappedColumnsAndUnits) {
  const log::LogFormat format =
      log::makeLogFormat({"displacement=Weg", "force=Kraft", "time=t"}, "displacement=cm force=tonf", 0.0);
  const log::Log log = readText("t,Weg,Kraft\n0,1,1\n0.5,2,2\n", format);
  EXPECT_THAT(log.displacement, ElementsAre(0.01, 0.02));
  // 1 tonf is 1000 kgf = 9806.65 N by definition; a few units of rounding in the chain of conversions.
  EXPECT_NEAR(log.force[1], 2 * 9806.65, 1e-9);
}

TEST(ReadCsvLog, AMappedColumnKeepsTheUnitInItsName) {
  const log::Log log = readText("time_s,rig_mm,cell_kN\n0,1,1\n1,2,2\n",
                                log::makeLogFormat({"displacement=rig_mm", "force=cell_kN"}, "", 0));
  EXPECT_THAT(log.displacement, ElementsAre(0.001, 0.002));
  EXPECT_THAT(log.force, ElementsAre(1000.0, 2000.0));
}

TEST(ReadCsvLog, ALogWithoutTimeTakesItsRate) {
  const log::Log log = readText("displacement_m\n0\n1\n2\n3\n", log::makeLogFormat({}, "", 3.0));
  EXPECT_THAT(log.stamp, ElementsAre(0, 333333333, 666666667, 1000000000));
}

TEST(ReadCsvLog, ARateOverridesATimeColumnAndSaysSo) {
  const log::Log log = readText("time_s,displacement_m\n5,0\n5,1\n", log::makeLogFormat({}, "", 100.0));
  EXPECT_THAT(log.stamp, ElementsAre(0, 10000000));
  EXPECT_THAT(
      log.notes,
      ElementsAre(
          "the stamps of column 'time_s' are replaced by --sampling-rate 100: 1 of 2 are not later than the one "
          "before"));
}

TEST(ReadCsvLog, AMappedTimeKeepsTheUnitInItsName) {
  const log::Log log = readText("time_ms,displacement_m\n0.1,0\n3,1\n", log::makeLogFormat({"time=time_ms"}, "", 0));
  EXPECT_THAT(log.stamp, ElementsAre(100000, 3000000));
}

TEST(ReadCsvLog, AUnitGoesBeforeThatOfTheHeaderAndSaysSo) {
  const log::Log bare =
      readText("time_s,displacement,force_kN\n0,1,1\n1,2,2\n", log::makeLogFormat({}, "displacement=mm force=N", 0));
  EXPECT_THAT(bare.displacement, ElementsAre(0.001, 0.002));
  EXPECT_THAT(bare.force, ElementsAre(1.0, 2.0));
  EXPECT_THAT(bare.notes, ElementsAre(HasSubstr("displacement from 'displacement', force from 'force_kN', 1 Hz"),
                                      "column 'force_kN' is taken to be in 'N', by --unit"));
}

TEST(LogFormat, TakesUnitsFromBracketsAndFromTheThirdPlace) {
  const std::vector<std::string> columns = {"time=T [ms]", "displacement=D (mm)", "force=F [kN]"};
  const log::Log brackets = readText("T [ms],D (mm),F [kN]\n0,1,2\n4.5,2,3\n", log::makeLogFormat(columns, "", 0));
  EXPECT_EQ(brackets.stamp, (std::vector<std::int64_t>{0, 4500000}));
  EXPECT_DOUBLE_EQ(brackets.displacement[0], 1e-3);
  EXPECT_DOUBLE_EQ(brackets.force[0], 2e3);
  EXPECT_THAT(brackets.notes,
              ElementsAre("time from 'T [ms]', displacement from 'D (mm)', force from 'F [kN]', 222.222 "
                          "Hz; header in line 1, separator comma"));
  const std::vector<std::string> bare = {"time=T", "displacement=D"};
  EXPECT_EQ(readText("T,D\n0,1\n4.5,2\n", log::makeLogFormat(bare, "displacement=mm time=ms", 0)).stamp[1], 4500000);
  EXPECT_EQ(readText("T,D\n0,1\n1.5,2\n", log::makeLogFormat(bare, "displacement=mm time=min", 0)).stamp[1],
            90000000000);
}

TEST(LogFormat, SaysWhichUnitsItAssumes) {
  const log::Log log =
      readText("T (DAQ),D\n0,1\n4.5,2\n", log::makeLogFormat({"time=T (DAQ)", "displacement=D"}, "", 0));
  EXPECT_EQ(log.stamp[1], 4500000000);
  EXPECT_THAT(log.notes, ElementsAre(HasSubstr("time from 'T (DAQ)', displacement from 'D'"),
                                     "column 'T (DAQ)' is taken to be in s; another unit by --unit",
                                     "column 'D' is taken to be in m; another unit by --unit"));
}

TEST(LogFormat, TakesAUnitInPlaceOfAName) {
  const log::LogFormat format = log::makeLogFormat({"time=1", "displacement=2", "force=3"}, "", 0);
  for (const char* header : {"ms,mm,kN", "ms,Position (mm),kN"}) {
    const log::Log log = readText(std::string(header) + "\n0,1,2\n4.5,2,3\n", format);
    EXPECT_EQ(log.stamp[1], 4500000) << header;
    EXPECT_DOUBLE_EQ(log.displacement[0], 1e-3) << header;
    EXPECT_DOUBLE_EQ(log.force[0], 2e3) << header;
  }
  // A unit of something else is a name.
  EXPECT_DOUBLE_EQ(
      readText("t,s\n0,1\n4.5,2\n", log::makeLogFormat({"time=t", "displacement=s"}, "", 0)).displacement[0], 1.0);
}

TEST(MakeLogFormat, WordsAloneAreTheColumnsInTheirOrder) {
  const log::LogFormat format = log::makeLogFormat({"force", "time", "displacement=D"}, "", 0);
  EXPECT_EQ(format.of[2].column, "1");
  EXPECT_EQ(format.of[0].column, "2");
  EXPECT_EQ(format.of[1].column, "D");
}

TEST(MakeLogFormat, RefusesWhatItCannotUse) {
  EXPECT_THROW(log::makeLogFormat({"displacement="}, "", 0), std::invalid_argument);
  EXPECT_THROW(log::makeLogFormat({"time", "time"}, "", 0), std::invalid_argument);
  EXPECT_THROW(log::makeLogFormat({"speed=v"}, "", 0), std::invalid_argument);
  EXPECT_THROW(log::makeLogFormat({}, "displacement=mm force=mm", 0), std::invalid_argument);
  EXPECT_THROW(log::makeLogFormat({}, "time=Hz", 0), std::invalid_argument);
  EXPECT_THROW(log::makeLogFormat({}, "mm,kN,s", 0), std::invalid_argument);
  EXPECT_THROW(log::makeLogFormat({}, "displacement=furlongs per fortnight", 0), std::invalid_argument);
  EXPECT_THROW(log::makeLogFormat({}, "", -1), std::invalid_argument);
  EXPECT_THROW(log::makeLogFormat({}, "", std::nan("")), std::invalid_argument);
}

TEST(ReadCsvLog, NamesALineThatIsTooLong) {
  EXPECT_THAT(errorOf("time_s,displacement_m\n0,0\n1," + std::string(100000, '1') + "\n"),
              HasSubstr(":3: line of more than 65536 bytes"));
}

TEST(ReadCsvLog, RefusesZeroBytes) {
  EXPECT_THAT(errorOf(std::string("time_s,displacement_m\n0,0\n1,\0001\n", 31)), HasSubstr(":3: holds a 0 byte"));
}

TEST(ReadCsvLog, NamesAFileThatCannotBeRead) {
  EXPECT_THROW(log::readCsvLog("/nonexistent/log.csv"), log::LogError);
  EXPECT_THROW(log::readCsvLog("/"), log::LogError);
}

// Time that this thread was at work [s]: what other programs take does not count.
double processorTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The shortest of some attempts, since the machine may be busy with other things.
double shortestTime(const std::function<void()>& work) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 5; ++attempt) {
    const double start = processorTime();
    work();
    shortest = std::min(shortest, processorTime() - start);
  }
  return shortest;
}

// The sum of all numbers of a text, as the C library reads them.
double sumOfNumbers(const std::string& text) {
  double sum = 0.0;
  for (const char* at = text.c_str(); *at != '\0';) {
    char* end = nullptr;
    sum += std::strtod(at, &end);
    at = end == at ? at + 1 : end;
  }
  return sum;
}

// Rows of 17 digits: the reader has to be fast enough never to be what a user waits for. It takes about as long as the
// C library takes for the numbers alone; three times that is for machines whose cores are shared.
TEST(ReadCsvLog, Reads130000RowsAboutAsFastAsTheirNumbers) {
  std::string text;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 130000; ++i) {
    char row[120];
    std::snprintf(row, sizeof row, "%.6f,%.17g,%.17g\n", i * 1e-3, 1e-3 * normal(random), 1e3 * normal(random));
    text += row;
  }
  const TemporaryFile file("log.csv", "time_s,displacement_m,force_N\n" + text);
  double sum = 0.0;
  const double numbers = shortestTime([&] { sum += sumOfNumbers(text); });
  const double reading = shortestTime([&] { ASSERT_EQ(log::readCsvLog(file.path()).size(), 130000U); });
  EXPECT_TRUE(std::isfinite(sum));
  RecordProperty("seconds", std::to_string(reading));
  std::printf("130,000 rows in %.1f ms, their numbers alone in %.1f ms\n", 1e3 * reading, 1e3 * numbers);
#ifdef NDEBUG
  EXPECT_LT(reading, 3.0 * numbers);
#endif
}

TEST(ReadCsvLog, ReadsTheMeasuredBearing) {
  const std::string path = measuredData("hdrb/hdrb_shear_4amplitudes.csv");
  if (!std::ifstream(path)) {
    GTEST_SKIP() << path << " is missing; RUBBER_SUSPENSION_DATA names the folder of measured logs";
  }
  const log::Log log = log::readCsvLog(path);
  EXPECT_EQ(log.size(), 26371u);
  EXPECT_EQ(log.stamp[0], 10000000);
  EXPECT_EQ(log.displacement[0], -0.0002616);
  EXPECT_EQ(log.force[0], -2536.6);
  EXPECT_NO_THROW(log::checkLog(log));
}

TEST(WriteForceCsv, ReadsBackBitByBit) {
  log::Log log;
  log.name = "out";
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<double> force;
  for (int i = 0; i < 1000; ++i) {
    log.stamp.push_back(-500000001 + i * 1234567891011LL);
    log.displacement.push_back(1e-3 * normal(random));
    force.push_back(1e5 * normal(random));
  }
  const TemporaryFile file("out.csv", "");
  log::writeForceCsv(file.path(), log, force);
  const log::Log read = log::readCsvLog(file.path());
  EXPECT_EQ(read.stamp, log.stamp);
  EXPECT_EQ(read.displacement, log.displacement);
  EXPECT_EQ(read.force, force);
  EXPECT_TRUE(read.notes.empty());
}

TEST(WriteForceCsv, NamesAFileThatCannotBeWritten) {
  log::Log log;
  log.stamp = {0, 1};
  log.displacement = {0.0, 0.0};
  EXPECT_THROW(log::writeForceCsv("/nonexistent/out.csv", log, {0.0, 0.0}), log::LogError);
  EXPECT_THROW(log::writeForceCsv("/dev/full", log, {0.0, 0.0}), log::LogError);
  EXPECT_THROW(log::writeForceCsv("/dev/null", log, {0.0}), log::LogError);
}

TEST(LogCsvWriter, LeavesAnOlderFileWholeUnlessItIsClosed) {
  const TemporaryFile file("out.csv", "older");
  {
    log::LogCsvWriter writer(file.path(), true);
    writer.append(0, 1.0, 2.0);
  }
  std::ifstream older(file.path());
  std::string content;
  std::getline(older, content);
  EXPECT_EQ(content, "older");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.folder()), {}), 1);
}

TEST(CheckLog, RefusesWhatALogMustNotHold) {
  log::Log good;
  good.name = "bag";
  good.stamp = {0, 10, 20};
  good.displacement = {0.0, 1.0, 2.0};
  EXPECT_NO_THROW(log::checkLog(good));

  log::Log bad = good;
  bad.stamp[2] = 10;
  EXPECT_THROW(log::checkLog(bad), log::LogError);
  bad = good;
  bad.force = {1.0, 2.0};
  EXPECT_THROW(log::checkLog(bad), log::LogError);
  bad = good;
  bad.temperature = {20.0, 20.0, std::nan("")};
  EXPECT_THROW(log::checkLog(bad), log::LogError);
  bad = good;
  bad.displacement.clear();
  EXPECT_THROW(log::checkLog(bad), log::LogError);
  bad.stamp = {0};
  bad.displacement = {0.0};
  EXPECT_THROW(log::checkLog(bad), log::LogError);
}

}  // namespace
}  // namespace rubber_suspension
