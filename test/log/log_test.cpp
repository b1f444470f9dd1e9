// Reading and writing CSV logs: values agree to the last bit, and refusals state the line and the reason.
#include "rubber_suspension/log/log.h"

#include <time.h>

#include <clocale>

#include "log/read_text.h"
#include "support/files.h"
#include "support/kit.h"
#include "support/measured_data.h"

namespace rubber_suspension {
namespace {

void expectNear(const std::vector<double>& values, const std::vector<double>& expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_DOUBLE_EQ(values[i], expected[i]) << "sample " << i;  // a conversion of units rounds several times
  }
}

// Checks the log that is read from a text, and that its notes begin with `notes`.
void expectRead(const std::string& name, const std::string& text, const log::LogFormat& format,
                const std::vector<std::int64_t>& stamp, const std::vector<double>& displacement,
                const std::vector<double>& force, const std::vector<std::string>& notes) {
  SCOPED_TRACE(name);
  const log::Log log = readText(text, format);
  EXPECT_EQ(log.name, "log");
  EXPECT_EQ(log.stamp, stamp);
  expectNear(log.displacement, displacement);
  expectNear(log.force, force);
  ASSERT_EQ(log.notes.size(), notes.size()) << ::testing::PrintToString(log.notes);
  for (std::size_t i = 0; i < notes.size(); ++i) {
    EXPECT_THAT(log.notes[i], ::testing::StartsWith(notes[i]));
  }
}

TEST(ReadCsvLog, GivesWhatATextSays) {
  expectRead("UnitsInColumnNames",
             "time_s,displacement_mm,force_kN,temperature_degC\n0,38,1.5,20\n0.001,-0.1,-2,20.5\n", {}, {0, 1000000},
             {0.038, -0.0001}, {1500.0, -2000.0}, {});
  expectRead("ColumnsInAnyOrder", "force_MN,cycle,displacement_um,time_s\n0.001,1,2000,0\n0.002,1,-3000,0.5\n", {},
             {0, 500000000}, {0.002, -0.003}, {1000.0, 2000.0}, {"column 'cycle' is ignored"});
  expectRead("WithoutForce", "time_s,displacement_m\n0,0\n1,1\n", {}, {0, 1000000000}, {0.0, 1.0}, {}, {});
  expectRead("CarriageReturnsByteOrderMarkQuotedNamesBlanksAndBlankEnd",
             "\xEF\xBB\xBF\"time_s\", \"displacement_m\"\r\n0, 0.5\r\n1 ,\t-0.5 \r\n\r\n\n", {}, {0, 1000000000},
             {0.5, -0.5}, {}, {});
  expectRead("ALastLineWithoutEnd", "time_s,displacement_m\n0,0\n1,0.25", {}, {0, 1000000000}, {0.0, 0.25}, {},
             {"the last line, 3, has no line end; it may have been cut off"});
  // The last stamp is a time since 1970. A double would represent it with an error of up to 119 ns.
  expectRead("TimeToTheNearestNanosecond",
             "time_s,displacement_m\n-0.5,0\n0.0000000014,0\n3.3333333335,0\n1732190400.123456789,0\n", {},
             {-500000000, 1, 3333333334, 1732190400123456789}, {0.0, 0.0, 0.0, 0.0}, {}, {});
  // 1 tonf is 1000 kgf = 9806.65 N by definition.
  expectRead("MappedColumnsAndUnits", "t,Weg,Kraft\n0,1,1\n0.5,2,2\n",
             byColumns({"displacement=Weg", "force=Kraft", "time=t"}, "displacement=cm force=tonf"), {0, 500000000},
             {0.01, 0.02}, {9806.65, 2 * 9806.65},
             {"time from 't', displacement from 'Weg', force from 'Kraft', 2 Hz", "column 't' is read in s"});
  expectRead("AMappedColumnKeepsTheUnitInItsName", "time_s,rig_mm,cell_kN\n0,1,1\n1,2,2\n",
             byColumns({"displacement=rig_mm", "force=cell_kN"}), {0, 1000000000}, {0.001, 0.002}, {1000.0, 2000.0},
             {"time from 'time_s', displacement from 'rig_mm', force from 'cell_kN', 1 Hz"});
  expectRead("ARateForATime", "displacement_m\n0\n1\n2\n3\n", byColumns({}, "", 3.0),
             {0, 333333333, 666666667, 1000000000}, {0.0, 1.0, 2.0, 3.0}, {},
             {"displacement from 'displacement_m', 3 Hz"});
  expectRead("ARateOverridesATimeColumn", "time_s,displacement_m\n5,0\n5,1\n", byColumns({}, "", 100.0), {0, 10000000},
             {0.0, 1.0}, {},
             {"the stamps of column 'time_s' are replaced by --sampling-rate 100: 1 of 2 stamps are not later than the "
              "preceding stamp"});
  expectRead("AMappedTimeKeepsTheUnitInItsName", "time_ms,displacement_m\n0.1,0\n3,1\n", byColumns({"time=time_ms"}),
             {100000, 3000000}, {0.0, 1.0}, {}, {"time from 'time_ms'"});
  expectRead("AUnitGoesBeforeThatOfTheHeader", "time_s,displacement,force_kN\n0,1,1\n1,2,2\n",
             byColumns({}, "displacement=mm force=N"), {0, 1000000000}, {0.001, 0.002}, {1.0, 2.0},
             {"time from 'time_s', displacement from 'displacement', force from 'force_kN', 1 Hz",
              "column 'force_kN' is read in 'N', as set with --unit"});
  expectRead(
      "UnitsInBrackets", "T [ms],D (mm),F [kN]\n0,1,2\n4.5,2,3\n",
      byColumns({"time=T [ms]", "displacement=D (mm)", "force=F [kN]"}), {0, 4500000}, {0.001, 0.002}, {2000.0, 3000.0},
      {"time from 'T [ms]', displacement from 'D (mm)', force from 'F [kN]', 222.222 Hz; header in line 1, separator "
       "comma"});
  expectRead("UnitsByOption", "T,D\n0,1\n4.5,2\n", byColumns({"time=T", "displacement=D"}, "displacement=mm time=ms"),
             {0, 4500000}, {0.001, 0.002}, {}, {"time from 'T', displacement from 'D'"});
  expectRead("MinutesByOption", "T,D\n0,1\n1.5,2\n",
             byColumns({"time=T", "displacement=D"}, "displacement=mm time=min"), {0, 90000000000}, {0.001, 0.002}, {},
             {"time from 'T', displacement from 'D'"});
  expectRead(
      "UnitsThatAreAssumed", "T (DAQ),D\n0,1\n4.5,2\n", byColumns({"time=T (DAQ)", "displacement=D"}), {0, 4500000000},
      {1.0, 2.0}, {},
      {"time from 'T (DAQ)', displacement from 'D'", "column 'T (DAQ)' is read in s; --unit selects another unit",
       "column 'D' is read in m; --unit selects another unit"});
  expectRead("AUnitInPlaceOfAName", "ms,mm,kN\n0,1,2\n4.5,2,3\n", byColumns({"time=1", "displacement=2", "force=3"}),
             {0, 4500000}, {0.001, 0.002}, {2000.0, 3000.0}, {"time from '1 [ms]'"});
  expectRead("AUnitInPlaceOfSomeNames", "ms,Position (mm),kN\n0,1,2\n4.5,2,3\n",
             byColumns({"time=1", "displacement=2", "force=3"}), {0, 4500000}, {0.001, 0.002}, {2000.0, 3000.0},
             {"time from 'ms'"});
  // Here "s" is the name of a displacement, not the unit of a time.
  expectRead("ASecondThatIsADisplacement", "t,s\n0,1\n4.5,2\n", byColumns({"time=t", "displacement=s"}),
             {0, 4500000000}, {1.0, 2.0}, {}, {"time from 't'", "", ""});
}

TEST(ReadCsvLog, HasATemperatureWhereThereIsOne) {
  EXPECT_THAT(readText("time_s,displacement_mm,temperature_degC\n0,38,20\n0.001,-0.1,20.5\n").temperature,
              ElementsAre(20.0, 20.5));
  EXPECT_TRUE(readText("time_s,displacement_m\n0,0\n1,1\n").temperature.empty());
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

TEST(MakeLogFormat, WordsAloneAreTheColumnsInTheirOrder) {
  const log::LogFormat format = byColumns({"force", "time", "displacement=D"});
  EXPECT_EQ(format.of[2].column, "1");
  EXPECT_EQ(format.of[0].column, "2");
  EXPECT_EQ(format.of[1].column, "D");
}

TEST(MakeLogFormat, RefusesWhatItCannotUse) {
  for (const std::vector<std::string>& columns :
       {std::vector<std::string>{"displacement="}, {"time", "time"}, {"speed=v"}}) {
    EXPECT_THROW(byColumns(columns), std::invalid_argument) << columns[0];
  }
  for (const char* units : {"displacement=mm force=mm", "time=Hz", "mm,kN,s", "displacement=furlongs per fortnight"}) {
    EXPECT_THROW(byColumns({}, units), std::invalid_argument) << units;
  }
  for (const double rate : {-1.0, std::nan("")}) {
    EXPECT_THROW(byColumns({}, "", rate), std::invalid_argument) << rate;
  }
}

TEST(ReadCsvLog, NamesALineThatIsTooLongAndOneWithAZeroByte) {
  EXPECT_THAT(refusalOf("time_s,displacement_m\n0,0\n1," + std::string(100000, '1') + "\n"),
              HasSubstr(":3: line of more than 65536 bytes"));
  EXPECT_THAT(refusalOf(std::string("time_s,displacement_m\n0,0\n1,\0001\n", 31)), HasSubstr(":3: holds a 0 byte"));
}

TEST(ReadCsvLog, NamesAFileThatCannotBeRead) {
  EXPECT_THROW(log::readCsvLog("/nonexistent/log.csv"), log::LogError);
  EXPECT_THROW(log::readCsvLog("/"), log::LogError);
}

// Returns the processor time of this thread [s], which excludes other programs.
double processorTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Returns the shortest time of five attempts [s], because other programs may slow down an attempt.
double shortestTime(const std::function<void()>& work) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 5; ++attempt) {
    const double start = processorTime();
    work();
    shortest = std::min(shortest, processorTime() - start);
  }
  return shortest;
}

// Returns the sum of all numbers in a text, parsed by the C library.
double sumOfNumbers(const std::string& text) {
  double sum = 0.0;
  for (const char* at = text.c_str(); *at != '\0';) {
    char* end = nullptr;
    sum += std::strtod(at, &end);
    at = end == at ? at + 1 : end;
  }
  return sum;
}

// Reading rows of 17 digits takes about as long as parsing their numbers with the C library. The limit is three times
// that, because other programs may share the processor cores.
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
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  log::Log log = logOf("out", 1000, 1234567891011, [&](int /*i*/) { return 1e-3 * normal(random); });
  std::vector<double> force;
  for (std::int64_t& stamp : log.stamp) {
    stamp -= 500000001;
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
  EXPECT_EQ(contentOf(file.path()), "older");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.folder()), {}), 1);
}

TEST(CheckLog, RefusesWhatALogMustNotHold) {
  const log::Log good = logOf("bag", 3, 10, [](int i) { return 1.0 * i; });
  EXPECT_NO_THROW(log::checkLog(good));
  const std::pair<const char*, void (*)(log::Log&)> changes[] = {
      {"a stamp twice", [](log::Log& log) { log.stamp[2] = 10; }},
      {"a force too few", [](log::Log& log) { log.force = {1.0, 2.0}; }},
      {"a temperature that is no number", [](log::Log& log) { log.temperature = {20.0, 20.0, std::nan("")}; }},
      {"no displacement", [](log::Log& log) { log.displacement.clear(); }},
      {"one sample", [](log::Log& log) {
         log.stamp = {0};
         log.displacement = {0.0};
       }}};
  for (const auto& [name, change] : changes) {
    log::Log bad = good;
    change(bad);
    EXPECT_THROW(log::checkLog(bad), log::LogError) << name;
  }
}

}  // namespace
}  // namespace rubber_suspension
