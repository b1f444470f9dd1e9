// Logs with channels of different rates, missing cells, codes for missing values, or unusual spellings of units. They
// are read correctly, or refused with an option that reads them.
#include "log/file_format.h"
#include "log/read_text.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr int kRows = 2000;

double displacementAt(int row) { return std::round(2000.0 * std::sin(0.01 * row)) / 1000.0; }  // [mm]
double forceAt(int row) { return std::round(4e4 * std::sin(0.01 * row + 0.1)) / 100.0; }       // [N]

using Cell = std::function<std::string(int row)>;

std::string number(double value) { return fmt::format("{:.6g}", value); }
Cell displacementCells() {
  return [](int row) { return number(displacementAt(row)); };
}
Cell forceCells() {
  return [](int row) { return number(forceAt(row)); };
}
Cell every(int step, const Cell& cell, const std::string& otherwise = "") {
  return [=](int row) { return row % step == 0 ? cell(row) : otherwise; };
}
Cell insteadAt(const std::vector<int>& rows, const std::string& text, const Cell& cell) {
  return [=](int row) { return std::count(rows.begin(), rows.end(), row) > 0 ? text : cell(row); };
}

// Returns the text of a table whose rows are 1 ms apart.
std::string table(const std::string& header, const std::vector<Cell>& cells) {
  std::string text = header + "\n";
  for (int row = 0; row < kRows; ++row) {
    text += fmt::format("{:.3f}", 1e-3 * row);
    for (const Cell& cell : cells) {
      text += "," + cell(row);
    }
    text += "\n";
  }
  return text;
}

const std::string kHeader = "time_s,displacement_mm,force_N";

void expectAllSamples(const log::Log& log, int compared) {
  ASSERT_EQ(log.size(), static_cast<std::size_t>(kRows));
  int counted = 0;
  for (int row = 0; row < kRows; ++row) {
    const auto i = static_cast<std::size_t>(row);
    EXPECT_DOUBLE_EQ(log.displacement[i], 1e-3 * displacementAt(row));
    if (log.counts.empty() || log.counts[i] > 0.0) {
      ++counted;
      EXPECT_DOUBLE_EQ(log.force[i], forceAt(row));
    }
  }
  EXPECT_EQ(counted, compared);
}

TEST(Signals, ASlowTemperatureLeavesTheOthers) {
  const Cell warming = [](int row) { return number(20.0 + 0.01 * row); };
  for (const std::string none : {"", "NaN"}) {
    const log::Log log =
        readText(table(kHeader + ",temperature_degC", {displacementCells(), forceCells(), every(100, warming, none)}));
    expectAllSamples(log, kRows);
    EXPECT_NEAR(log.temperature[50], 20.5, 1e-12);
    EXPECT_THAT(log.notes,
                Contains("column 'temperature_degC' has values at 10 Hz in only 20 of 2000 rows: interpolated"));
  }
}

TEST(Signals, AColumnWithoutANumberIsNotThere) {
  const log::Log log = readText(table(kHeader + ",temperature_degC",
                                      {displacementCells(), forceCells(), [](int) { return std::string("NaN"); }}));
  expectAllSamples(log, kRows);
  EXPECT_TRUE(log.temperature.empty());
  EXPECT_THAT(log.notes, Contains("column 'temperature_degC' has no number and is omitted"));
  const log::Log without = readText(table(kHeader, {displacementCells(), [](int) { return std::string(); }}));
  EXPECT_TRUE(without.force.empty());
}

TEST(Signals, ASlowForceIsComparedWhereItIs) {
  const log::Log log = readText(table(kHeader, {displacementCells(), every(4, forceCells())}));
  expectAllSamples(log, kRows / 4);
  EXPECT_THAT(log.notes, Contains(HasSubstr("has values at 250 Hz in only 500 of 2000 rows")));
}

TEST(Signals, AMissingForceLeavesItsDisplacement) {
  const log::Log log = readText(table(kHeader, {displacementCells(), insteadAt({7, 8, 900}, "OL", forceCells())}));
  expectAllSamples(log, kRows - 3);
  EXPECT_THAT(log.notes, Contains(HasSubstr("the first row without a value is line 9: force_N: 'OL' is not a number")));
}

// The two topics in the table never have values in the same row.
TEST(Signals, OfTwoClocksAreInterpolated) {
  const auto cells = [](int even, const Cell& cell) {
    return [=](int row) { return row % 2 == even ? cell(row) : std::string(); };
  };
  const log::Log log = readText(table(kHeader, {cells(0, displacementCells()), cells(1, forceCells())}));
  ASSERT_EQ(log.size(), static_cast<std::size_t>(kRows / 2));
  for (std::size_t i = 1; i < log.size(); ++i) {
    const int row = 2 * static_cast<int>(i);
    EXPECT_DOUBLE_EQ(log.displacement[i], 1e-3 * displacementAt(row));
    EXPECT_NEAR(log.force[i], 0.5 * (forceAt(row - 1) + forceAt(row + 1)), 1e-9);
    EXPECT_EQ(log.counts.empty() ? 1.0 : log.counts[i], 1.0);
  }
}

// The gap is longer than three time steps of the force.
TEST(Signals, AreNotInterpolatedOverAGap) {
  const Cell force = [](int row) { return row % 2 == 1 && (row < 500 || row > 600) ? forceCells()(row) : ""; };
  const log::Log log = readText(table(kHeader, {every(2, displacementCells()), force}));
  EXPECT_EQ(log.counts[275], 0.0);
  EXPECT_EQ(log.counts[200], 1.0);
}

// An error does not advise an option that would omit more than a tenth of the rows.
TEST(Signals, ALostDisplacementIsBridgedWhereLittleIsLost) {
  std::vector<int> few;
  std::vector<int> many;
  for (int i = 0; i < 60; ++i) {
    few.push_back(20 + 30 * i);
  }
  for (int i = 0; i < 400; ++i) {
    many.push_back(3 + 4 * i);
  }
  const std::string text = table(kHeader, {insteadAt(few, "Overrun", displacementCells()), forceCells()});
  const std::string error = refusalOf(text);
  EXPECT_THAT(error, HasSubstr(":22: displacement_mm: 'Overrun' is not a number"));
  EXPECT_EQ(readText(text, advised(error, "--bridge")).size(), static_cast<std::size_t>(kRows - 60));
  const std::string worse = refusalOf(table(kHeader, {insteadAt(many, "Overrun", displacementCells()), forceCells()}));
  EXPECT_THAT(worse, AllOf(HasSubstr("400 of 2000 rows lack a number"), Not(HasSubstr("--bridge"))));
}

TEST(Sentinels, AreNoMeasurements) {
  for (const std::string value : {"-9999", "9.9E37", "1e30", "999.999"}) {
    const log::Log log =
        readText(table(kHeader, {insteadAt({700, 701, 1500}, value, displacementCells()), forceCells()}));
    EXPECT_EQ(log.size(), static_cast<std::size_t>(kRows - 3)) << value;
    EXPECT_THAT(log.notes, Contains(AllOf(HasSubstr("displacement_mm: 3 cells of "),
                                          HasSubstr("in line 702, 703, 1502"), HasSubstr("--sentinel none"))));
  }
  const log::Log forces = readText(table(kHeader, {displacementCells(), insteadAt({700, 900}, "1e30", forceCells())}));
  expectAllSamples(forces, kRows - 2);
}

TEST(Sentinels, AreKeptOrNamedByTheOption) {
  const std::string text = table(kHeader, {insteadAt({700, 701, 1500}, "-9999", displacementCells()), forceCells()});
  const auto by = [](const std::string& value) { return byOption("--sentinel", value); };
  EXPECT_DOUBLE_EQ(readText(text, by("none")).displacement[700], -9.999);
  const std::string near = table(kHeader, {insteadAt({700, 1500}, "99", displacementCells()), forceCells()});
  EXPECT_EQ(readText(near).size(), static_cast<std::size_t>(kRows));
  EXPECT_EQ(readText(near, by("99")).size(), static_cast<std::size_t>(kRows - 2));
  EXPECT_THROW(by("nothing"), std::invalid_argument);
}

TEST(Sentinels, OfManyRowsAreRefusedWithAnOption) {
  std::vector<int> rows;
  for (int i = 0; i < 40; ++i) {
    rows.push_back(10 + 45 * i);
  }
  const std::string text = table(kHeader, {insteadAt(rows, "-9999", displacementCells()), forceCells()});
  const std::string error = refusalOf(text);
  EXPECT_THAT(error, HasSubstr("40 cells of -9999, far outside -2 to 2"));
  EXPECT_EQ(readText(text, advised(error, "--bridge")).size(), static_cast<std::size_t>(kRows - 40));
  EXPECT_EQ(readText(text, advised(error, "--sentinel")).size(), static_cast<std::size_t>(kRows));
}

// Peaks, clipped channels and steps are measured values, not codes for missing values.
TEST(Sentinels, AreNoPeaksOrSteps) {
  const Cell quiet = [](int row) { return number(0.001 * (row % 3)); };
  const std::vector<Cell> measured = {insteadAt({700}, "5000", displacementCells()),       // one spike
                                      insteadAt({700, 1500}, "150", displacementCells()),  // two high peaks
                                      [](int row) { return number(std::min(displacementAt(row), 0.5)); },   // clipped
                                      [&](int row) { return row < 1000 ? quiet(row) : "5"; },               // a step
                                      [&](int row) { return row > 500 && row < 1500 ? "5" : quiet(row); },  // a plateau
                                      [](int row) { return row / 200 % 2 == 0 ? "0" : "5"; },  // a rectangle
                                      [](int row) {
                                        return row % 500 < 3 ? number(300.0 * (1 + row % 500 % 2))
                                                             : number(0.01 * (row % 7));
                                      }};  // pulses
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const log::Log log = readText(table(kHeader, {measured[i], forceCells()}));
    EXPECT_EQ(log.size(), static_cast<std::size_t>(kRows)) << i;
    EXPECT_THAT(log.notes, Not(Contains(HasSubstr("missing values")))) << i;
  }
}

// The time restarts, as LabVIEW's X_Value or the time within each cycle of a test do.
TEST(Restarts, OfTheTimeAreSegments) {
  std::string text = kHeader + "\n";
  for (int row = 0; row < kRows; ++row) {
    text += fmt::format("{:.3f},{},{}\n", 1e-3 * (row % 250), displacementAt(row), forceAt(row));
  }
  const std::string error = refusalOf(text);
  EXPECT_THAT(error, HasSubstr("the file contains 8 logs: lines 2 to 251, lines 252 to 501"));
  const log::Log first = readText(text, advised(error, "--segment"));
  EXPECT_EQ(first.size(), 250U);
  EXPECT_EQ(first.stamp[249], 249000000);
  const log::Log whole = readText(text, advised(error, "--sampling-rate"));
  expectAllSamples(whole, kRows);
  EXPECT_EQ(whole.stamp[kRows - 1], 1999000000);
  const TemporaryFile file("log.csv", text);
  EXPECT_EQ(log::readLogs(file.path(), byOption("--segment", "all")).size(), 8U);
}

// A counter that overflows restarts at another value than it had in the first row.
TEST(Restarts, OfACounterTellTheRateOfItsSteps) {
  std::string text = "time [ns],displacement_mm\n";
  for (int row = 0; row < kRows; ++row) {
    text += fmt::format("{},{}\n", (430000000LL + 1000000LL * row) % 1000000000LL, displacementAt(row));
  }
  EXPECT_EQ(advised(refusalOf(text), "--sampling-rate").rate, 1000.0);
}

TEST(Times, MayBeDurations) {
  const auto stamp = [](const std::string& first, const std::string& second, const log::LogFormat& format = {}) {
    const log::Log log = readText("Time,displacement_mm\n" + first + ",1\n" + second + ",2\n", format);
    return log.stamp[1] - log.stamp[0];
  };
  EXPECT_EQ(stamp("0 sec", "0.001 sec"), 1000000);
  EXPECT_EQ(stamp("0 sec", "0.001 sec", byOption("--unit", "time=s")), 1000000);
  EXPECT_EQ(stamp("0 ms", "1.5 ms"), 1500000);
  EXPECT_EQ(stamp("0 days 00:00:00", "0 days 00:00:00.001000"), 1000000);
  EXPECT_EQ(stamp("-1 days +23:59:59.999", "1 days 00:00:00"), 86400001000000);
}

TEST(Headers, OfExportsAreRead) {
  const std::string rows = "0,1,2\n0.001,2,3\n0.002,3,4\n";
  const std::string unnamed = ",displacement [mm],force [N]\n" + rows;
  EXPECT_THAT(refusalOf(unnamed), HasSubstr("--columns time=1 --unit time=s"));
  for (const log::Log& log :
       {readText(unnamed, byColumns({"time=1"}, "time=s")), readText(unnamed, byColumns({"time=1"})),
        readText("ETASAsciiItemFile,record\ntime,Weg,Kraft\nf8,f4,f4\ns,mm,N\n" + rows),
        readText("1,Time,Displacement,Force\n,(s),(mm),(N)\n\"\",\"0\",\"1\",\"2\"\n\"\",\"0.001\",\"2\",\"3\"\n")}) {
    EXPECT_EQ(log.stamp[1], 1000000);
    EXPECT_DOUBLE_EQ(log.displacement[1], 2e-3);
    EXPECT_DOUBLE_EQ(log.force[1], 3.0);
  }
}

TEST(UnitSpellings, AreThoseOfBrackets) {
  const auto force = [](const std::string& name, const log::LogFormat& format = {}) {
    return readText("time_s,displacement_mm," + name + "\n0,1,1\n1,2,2\n", format).force.at(0);
  };
  for (const auto& [unit, newton] : {std::pair("kgf", 9.80665),
                                     {"daN", 10.0},
                                     {"mN", 1e-3},
                                     {"kp", 9.80665},
                                     {"lbs", 4.4482216152605},
                                     {"KN", 1e3},
                                     {"gf", 9.80665e-3}}) {
    for (const std::string form : {"force_{}", "Load {}", "Load_{}", "Force ({})", "Kraft [{}]"}) {
      EXPECT_NEAR(force(fmt::format(fmt::runtime(form), unit)), newton, 1e-12 * newton) << unit << form;
    }
  }
  for (const char* name : {"load_kg", "Load (kg)", "load_g", "force_t"}) {
    const std::string error = refusalOf(fmt::format("time_s,displacement_mm,{}\n0,1,1\n1,2,2\n", name));
    EXPECT_THAT(error, AllOf(HasSubstr(name), HasSubstr("cannot be converted to N"), HasSubstr("--unit force=")));
  }
  EXPECT_DOUBLE_EQ(force("load_g", byOption("--unit", "force=gf")), 9.80665e-3);
  EXPECT_THAT(refusalOf("time_s,displacement_mm\n0,1\n1,2\n", byOption("--unit", "force=gf")),
              HasSubstr("--unit force=gf: there is no column of force"));
  EXPECT_THAT(readText("time_s,displacement_mm,force_in\n0,1,1\n1,2,2\n").notes,
              Contains(HasSubstr("column 'force_in' is ignored; if it is the measured force, use --columns force=3")));
}

// These are the columns that an error advises for the output of rostopic echo.
TEST(Formats, ThatRostopicWritesAreReadByTheColumnsThatAreAdvised) {
  const log::Log log =
      readText("%time,field.header.seq,field.displacement\n1764244000000000000,0,0.001\n1764244000001000000,1,0.002\n",
               byColumns({"time=%time", "displacement=field.displacement"}, "time=ns displacement=m"));
  EXPECT_EQ(log.stamp[1] - log.stamp[0], 1000000);
  EXPECT_EQ(log.displacement[1], 0.002);
}

TEST(Formats, AreNamedByTheirFirstBytes) {
  using namespace std::string_literals;
  const std::string zip = "PK\x03\x04"s + std::string(22, '\0');
  const auto inZip = [&](const std::string& name) {
    return zip + std::string(1, static_cast<char>(name.size())) + std::string(3, '\0') + name;
  };
  for (const auto& [bytes, name] : {std::pair("header: \n  seq: 0\n  stamp: \n"s, "output of rostopic echo"),
                                    {"data: 0.1\n---\ndata: 0.2\n"s, "output of rostopic echo"},
                                    {"{\"t\": 0, \"z\": 1}\n{\"t\": 1}\n"s, "JSON"},
                                    {"[{\"t\": 0}]"s, "JSON"},
                                    {"\x80\x04\x95"s, "a pickle of Python"},
                                    {"    -1\n    58\n"s, "a universal file (UFF 58)"},
                                    {"#BEGINGLOBALHEADER\n101,log\n"s, "the header of a DIAdem file"},
                                    {inZip("time.npy"), "arrays of NumPy (.npz)"},
                                    {inZip("[Content_Types].xml"), "a spreadsheet (.xlsx)"},
                                    {inZip("log.csv"), "a ZIP archive"},
                                    {"SQLite format 3\0"s, "SQLite"},
                                    {"\xD0\xCF\x11\xE0"s, "an old spreadsheet (.xls)"}}) {
    EXPECT_THAT(refusalOf(bytes), AllOf(HasSubstr(name), HasSubstr("to convert it: "))) << name;
  }
  EXPECT_EQ(log::formatOf("[s],[mm],[N]\n0,1,2\n"), log::FileFormat::text);
}

// Draws a file with several rates and missing cells, and its content.
class Drawn {
 public:
  explicit Drawn(unsigned seed) : random_(seed) {
    const auto [unit, newton_of_unit] = of<std::pair<const char*, double>>({{"N", 1.0},
                                                                            {"kN", 1e3},
                                                                            {"daN", 10.0},
                                                                            {"kgf", 9.80665},
                                                                            {"mN", 1e-3},
                                                                            {"lbs", 4.4482216152605},
                                                                            {"kp", 9.80665},
                                                                            {"KN", 1e3}});
    newton = newton_of_unit;
    force_step = of<int>({1, 1, 2, 4, 10});
    const std::string nothing = of<std::string>({"", "", "NaN", "nan"});
    const std::string stands_for_none =
        chance() ? of<std::string>({"-9999", "9.9E37", "1e30", "-1e6"}) : of<std::string>({"OL", "--", "#N/A"});
    Cell motion = displacementCells();
    Cell force = every(force_step, forceCells(), nothing);
    if (chance()) {
      for (int i = upTo(5); i > 0; --i) {
        lost.insert(10 + 40 * upTo(45));
      }
      if (lost.size() == 1) {
        lost.insert(1900);
      }
      motion = insteadAt({lost.begin(), lost.end()}, stands_for_none, motion);
    }
    if (chance()) {
      no_force = {100, 200 + 20 * upTo(50)};
      force = insteadAt({no_force.begin(), no_force.end()}, chance() ? "9.9E37" : "OL", force);
    }
    std::vector<Cell> cells = {motion, force};
    const auto form = of<std::string>({"force_{}", "Kraft [{}]", "Load {}", "Load_{}"});
    std::string header = "time_s,Weg [mm]," + fmt::format(fmt::runtime(form), unit);
    const int temperature = upTo(3);
    warm = temperature == 1 || temperature == 2;
    if (temperature > 0) {
      header += ",temperature_degC";
      const Cell warming = [](int row) { return number(20.0 + 0.01 * row); };
      cells.push_back(temperature == 1   ? every(of<int>({1, 7, 100}), warming, nothing)
                      : temperature == 2 ? insteadAt({500, 501}, "OL", warming)
                                         : [=](int) { return nothing; });
    }
    if (chance()) {
      header += ",Spare";
      cells.push_back([=](int) { return nothing; });
    }
    text = table(header, cells);
  }

  std::string text;
  double newton = 1.0;
  int force_step = 1;
  std::set<int> lost;  // rows without a displacement
  std::set<int> no_force;
  bool warm = false;

 private:
  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  bool chance() { return upTo(1) == 0; }
  template <class Value>
  Value of(const std::vector<Value>& values) {
    return values[static_cast<std::size_t>(upTo(static_cast<int>(values.size()) - 1))];
  }

  std::mt19937 random_;
};

TEST(Signals, OfRandomDialectsAreReadRight) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const Drawn drawn(seed);
    const std::string refusal = refusalOf(drawn.text);
    ASSERT_EQ(refusal, "") << drawn.text.substr(0, 200);
    const log::Log log = readText(drawn.text);
    ASSERT_EQ(log.size(), static_cast<std::size_t>(kRows) - drawn.lost.size()) << drawn.text.substr(0, 200);
    ASSERT_EQ(log.temperature.size(), drawn.warm ? log.size() : 0U);
    std::size_t i = 0;
    for (int row = 0; row < kRows; ++row) {
      if (drawn.lost.count(row) > 0) {
        continue;
      }
      ASSERT_EQ(log.stamp[i], std::int64_t{1000000} * row);
      ASSERT_DOUBLE_EQ(log.displacement[i], 1e-3 * displacementAt(row));
      const bool has_force = row % drawn.force_step == 0 && drawn.no_force.count(row) == 0;
      ASSERT_EQ(log.counts.empty() || log.counts[i] > 0.0, has_force) << row;
      if (has_force) {
        ASSERT_NEAR(log.force[i], drawn.newton * forceAt(row), 1e-11 * drawn.newton * 400.0);
      }
      if (drawn.warm) {
        ASSERT_NEAR(log.temperature[i], 20.0 + 0.01 * row, 1.0);
      }
      ++i;
    }
  }
}

}  // namespace
}  // namespace rubber_suspension
