// Logs as instruments and spreadsheets write them, drawn at random: separators, decimal and thousands marks, units in
// the header, in a row below or in the preamble, times as numbers, clocks or dates, several logs in one file, repeated
// headers, missing cells, statistics below the data.
#include "log/read_text.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

// All numbers are multiples of a thousandth, so that their text is exact.
struct Sample {
  std::int64_t time_ms;
  std::int64_t displacement_um;
  std::int64_t force_mN;
  bool has_force = true;
};

enum class TimeStyle { number, clock, date };

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  bool chance() { return upTo(1) == 1; }
  template <class Values>
  auto of(const Values& values) {
    return values[static_cast<std::size_t>(upTo(static_cast<int>(std::size(values)) - 1))];
  }

 private:
  std::mt19937 random_;
};

// Draws a file and its content.
class Dialect {
 public:
  explicit Dialect(unsigned seed) : draw_(seed) {
    separator_ = draw_.of(std::array<char, 3>{';', '\t', ','});
    decimal_ = draw_.chance() ? ',' : '.';
    thousands_ = draw_.chance();
    group_mark_ = draw_.of(std::array<const char*, 4>{"", "", "'", "\u00A0"});
    quotes_ = separator_ == ',';
    units_row_ = draw_.chance();
    style_ = draw_.of(std::array<TimeStyle, 3>{TimeStyle::number, TimeStyle::clock, TimeStyle::date});
    trailing_ = draw_.chance();
    end_ = draw_.chance() ? "\r\n" : "\n";
    brackets_ = draw_.upTo(3) == 0;
    statistics_ = draw_.upTo(3) == 0;
    buffer_ = draw_.upTo(3) == 0 ? 20 + draw_.upTo(60) : 0;
    const int segments = draw_.upTo(3) == 0 ? 1 + draw_.upTo(2) : 1;
    for (int i = 0; i < segments; ++i) {
      addSegment();
    }
    if (statistics_) {
      addCells({"Min", numberText(-4321), numberText(-3000000)});
      addCells({"Mittelwert", numberText(0), numberText(12)});
    }
  }

  const std::string& text() const { return text_; }
  const std::vector<std::vector<Sample>>& logs() const { return logs_; }
  std::size_t leftOut() const { return left_out_; }
  std::size_t repeats() const { return repeats_; }
  std::int64_t startMs() const { return style_ == TimeStyle::number ? 0 : kBeforeMidnight; }
  TimeStyle style() const { return style_; }

 private:
  static constexpr std::int64_t kBeforeMidnight = 86399000;  // time of day [ms]

  void addSegment() {
    if (!logs_.empty()) {
      text_ += end_;
    }
    preamble_ = draw_.upTo(3);
    const std::size_t begin = text_.size();
    addHeader();
    const std::string header = text_.substr(begin);
    std::vector<Sample> samples;
    const int count = 150 + draw_.upTo(200);
    const bool gaps = draw_.chance();
    const std::int64_t scale = draw_.chance() ? 3000000 : 30000000;
    for (int i = 0; i < count; ++i) {
      const double angle = 0.05 * i;
      Sample sample{10 * i, std::llround(4321.0 * std::sin(angle)),
                    std::llround(static_cast<double>(scale) * std::sin(angle + 0.1))};
      const bool bad = gaps && i == count / 2;
      if (buffer_ > 0 && i > 0 && i % buffer_ == 0) {
        text_ += (draw_.chance() ? end_ : "") + header;
        ++repeats_;
      }
      addRow(sample, bad);
      left_out_ += bad ? 1 : 0;
      sample.has_force = !bad;
      samples.push_back(sample);
    }
    logs_.push_back(samples);
  }

  void addHeader() {
    const char* time = style_ == TimeStyle::number ? "Time" : "Timestamp";
    if (preamble_ % 2 == 1) {
      text_ += fmt::format("Bench 7{}Operator: lab{}", end_, end_);
    }
    const std::string time_unit = style_ == TimeStyle::number ? "Sec" : "";
    const std::string mm = draw_.of(std::array<const char*, 3>{"mm", "MM", "millimeter"});
    const std::string newton = draw_.of(std::array<const char*, 3>{"N", "newton", "N"});
    if (units_row_) {
      std::vector<std::string> names = {time, "Travel", "Axial Load"};
      std::vector<std::string> units = {time_unit, mm, newton};
      if (brackets_) {
        names = {time, "Travel (Ch 1)", draw_.of(std::array<const char*, 2>{"Force (Ch 2)", "Load (A)"})};
        addCells(names);
        addCells(units);
        return;
      }
      if (preamble_ == 2 && style_ == TimeStyle::number) {  // units in the preamble, after a cell that announces them
        addCells({"Channel", "1", "2", "3"});
        addCells({"Units", time_unit, mm, newton});
        addCells(names);
        return;
      }
      const int below = 1 + draw_.upTo(1);  // at least one unit is in the row below, others may be in the name
      for (int i = 0; i < 3; ++i) {
        if (i != below && !units[i].empty() && draw_.chance()) {
          names[i] += " [" + std::exchange(units[i], "") + "]";
        }
      }
      addCells(names);
      addCells(units);
    } else {
      const bool short_names = draw_.chance();
      const char* const mark = draw_.of(std::array<const char*, 2>{"/", " "});
      if (short_names && style_ == TimeStyle::number) {
        addCells({fmt::format("t{}s", mark), fmt::format("s{}mm", mark), fmt::format("F{}N", mark)});
        return;
      }
      addCells({time + (time_unit.empty() ? "" : " [" + time_unit + "]"), "Travel (" + mm + ")",
                "Axial Load [" + newton + "]"});
    }
  }

  void addCells(const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      text_ += (i > 0 ? std::string(1, separator_) : "") + cells[i];
    }
    text_ += (trailing_ ? std::string(1, separator_) : "") + end_;
  }

  void addRow(const Sample& sample, bool bad) {
    static constexpr std::array<const char*, 9> kWords = {"",   "NaN",  "-inf",    "OL", "Overrun",
                                                          "--", "#N/A", "1.#QNAN", "n/a"};
    addCells({timeText(sample.time_ms), numberText(sample.displacement_um),
              bad ? draw_.of(kWords) : numberText(sample.force_mN)});
  }

  std::string timeText(std::int64_t ms) const {
    if (style_ == TimeStyle::number) {
      return numberText(ms);
    }
    const std::int64_t of_day = (kBeforeMidnight + ms) % 86400000;
    const std::int64_t day = 12 + (kBeforeMidnight + ms) / 86400000;
    const std::string clock = fmt::format("{:02d}:{:02d}:{:02d}.{:03d}", of_day / 3600000, of_day / 60000 % 60,
                                          of_day / 1000 % 60, of_day % 1000);
    return style_ == TimeStyle::clock ? clock : fmt::format("{:02d}.03.2025 {}", day, clock);
  }

  // Formats a number given in thousandths with three decimals and, if drawn, with thousands marks.
  std::string numberText(std::int64_t thousandths) const {
    const std::int64_t whole = std::abs(thousandths) / 1000;
    std::string digits = std::to_string(whole);
    if (thousands_ && whole >= 1000) {
      digits.insert(digits.size() - 3, group_mark_.empty() ? std::string(1, decimal_ == ',' ? '.' : ',') : group_mark_);
    }
    const std::string text =
        fmt::format("{}{}{}{:03d}", thousandths < 0 ? "-" : "", digits, decimal_, std::abs(thousandths) % 1000);
    return quotes_ ? "\"" + text + "\"" : text;
  }

  Draw draw_;
  char separator_ = ';';
  char decimal_ = '.';
  bool thousands_ = false;
  std::string group_mark_;  // if empty, it is the dot or comma that is not the decimal mark
  bool quotes_ = false;
  bool units_row_ = false;
  bool trailing_ = false;
  bool brackets_ = false;    // brackets in the names, without a unit
  bool statistics_ = false;  // statistics below the data
  int buffer_ = 0;           // number of rows after which the header repeats; 0: never
  int preamble_ = 0;
  std::size_t repeats_ = 0;
  TimeStyle style_ = TimeStyle::number;
  std::string end_;
  std::string text_;
  std::vector<std::vector<Sample>> logs_;
  std::size_t left_out_ = 0;
};

void expectLog(const log::Log& log, const std::vector<Sample>& samples, const Dialect& dialect) {
  ASSERT_EQ(log.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(log.stamp[i] - log.stamp[0], (samples[i].time_ms - samples[0].time_ms) * 1000000);
    // Both the decimal number and its unit are rounded.
    EXPECT_NEAR(log.displacement[i], 1e-6 * static_cast<double>(samples[i].displacement_um), 1e-17);
    EXPECT_EQ(log.counts.empty() || log.counts[i] > 0.0, samples[i].has_force);
    if (samples[i].has_force) {
      EXPECT_NEAR(log.force[i], 1e-3 * static_cast<double>(samples[i].force_mN), 1e-11);
    }
  }
  const std::int64_t day = dialect.style() == TimeStyle::date ? 20159 : 0;  // days from 1970 to 12 March 2025
  EXPECT_EQ(log.stamp[0], (day * 86400000 + dialect.startMs() + samples[0].time_ms) * 1000000);
}

TEST(Dialects, SayWhatTheirWriterWrote) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const Dialect dialect(seed);
    const TemporaryFile file("log.csv", dialect.text());
    SCOPED_TRACE(dialect.text().substr(0, 300));
    log::LogFormat format;
    format.segment = log::kAllSegments;
    const std::vector<log::Log> logs = log::readLogs(file.path(), format);
    ASSERT_EQ(logs.size(), dialect.logs().size());
    std::size_t noted = 0;
    std::size_t repeats = 0;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      expectLog(logs[i], dialect.logs()[i], dialect);
      for (const std::string& note : logs[i].notes) {
        noted += note.find("have a force") != std::string::npos ? 1 : 0;
        const std::size_t repeat = note.find("the header is repeated ");
        repeats += repeat != std::string::npos ? std::stoul(note.substr(repeat + 23)) : 0;
      }
      format.segment = i + 1;
      expectLog(log::readLog(file.path(), format), dialect.logs()[i], dialect);
      format.segment = log::kAllSegments;
    }
    EXPECT_EQ(repeats, dialect.repeats());
    EXPECT_EQ(noted, dialect.leftOut());  // a log has at most one such note
    if (logs.size() > 1) {
      EXPECT_THROW(log::readLog(file.path()), log::LogError);
    } else {
      expectLog(log::readLog(file.path(), byColumns({"time", "displacement", "force"})), dialect.logs()[0], dialect);
    }
    if (::testing::Test::HasFailure()) {
      return;
    }
  }
}

TEST(Advice, SettlesWhetherMarksAreThousands) {
  const std::string text = "Time [ms];Travel [um];Force [N]\n0;1;998\n5;2;999\n10;3;1.000\n15;4;1.001\n";
  const std::string error = refusalOf(text);
  EXPECT_THAT(error, HasSubstr(":4: Force [N]: the mark in '1.000' may be a decimal mark or a thousands separator"));
  EXPECT_EQ(readText(text, advised(error, "--decimal")).force[2], 1.0);
  EXPECT_EQ(readText(text, byOption("--decimal", ",")).force[2], 1000.0);
}

// Columns with a clear decimal mark determine that of all columns, unless a smooth channel would then jump.
TEST(Advice, LeavesTheMarkToTheOtherColumns) {
  const std::string head = "Time [s];Travel [mm];Force [N]\n";
  EXPECT_EQ(readText(head + "0,005;1,25;998\n0,010;1,5;1.002\n", {}).force[1], 1002.0);
  EXPECT_EQ(readText(head + "0.005;1.25;1\n0.010;1.5;1.125\n", {}).force[1], 1.125);
  const std::string both = head + "0.005;1.25;998\n0.010;1.5;1.002\n";
  const std::string error = refusalOf(both);
  EXPECT_THAT(error, HasSubstr("or --decimal force=, if it separates thousands"));
  EXPECT_EQ(readText(both, advised(error, "--decimal")).force[1], 1.002);
  EXPECT_EQ(readText(both, byOption("--decimal", "force=,")).force[1], 1002.0);
  EXPECT_EQ(readText("time_s,displacement_mm,force_N\n0.0,1.5,998\n0.1,1.6,1.002\n", byOption("--decimal", "force=,"))
                .force[1],
            1002.0);
}

// A decimal mark applies to all numbers of a column, even if only a late number determines it.
TEST(Advice, ReadsAgainWhereALateNumberTellsTheMark) {
  EXPECT_EQ(readText("Time [s];Travel [um]\n1;1.250\n2;1.500\n3;2,5\n", {}).displacement[0], 1250e-6);
}

TEST(Advice, ReplacesStampsThatAreEqualSwappedOrRounded) {
  for (const int kind : {0, 1, 2}) {
    std::string text = "time_s,displacement_mm,force_N\n";
    for (int i = 0; i < 200; ++i) {
      const int swapped = i == 100 ? 101 : i == 101 ? 100 : i;
      const double time = kind == 0 ? 0.05 * (i / 10) : kind == 1 ? 0.005 * swapped : std::round(0.5 * i) * 0.01;
      text += fmt::format("{:.6f},{},{}\n", time, i, 2 * i);
    }
    const std::string error = refusalOf(text);
    const log::Log log = readText(text, advised(error, "--sampling-rate"));
    ASSERT_EQ(log.size(), 200U) << error;
    EXPECT_EQ(log.stamp[199], 199 * 5000000) << error;
    EXPECT_THAT(log.notes.back(), HasSubstr("are replaced by --sampling-rate 200"));
  }
}

// The clock shows whole seconds. The recording begins and ends within a second.
TEST(Advice, CountsTheRowsOfWholeSeconds) {
  std::string text = "Timestamp,displacement_mm,force_N\n";
  for (int i = 0; i < 2000; ++i) {
    text += fmt::format("10:11:{:02d},{},{}\n", 10 + (130 + i) / 200, i % 17, i % 13);
  }
  EXPECT_EQ(advised(refusalOf(text), "--sampling-rate").rate, 200.0);
}

TEST(Advice, KeepsGoodStampsAgainstAnotherRate) {
  const std::string text = "time_s,displacement_mm\n0,1\n0.005,2\n0.01,3\n";
  const std::string error = refusalOf(text, byOption("--sampling-rate", "2000.0"));
  EXPECT_THAT(error, HasSubstr("--sampling-rate is 2000 Hz, but the stamps of column 'time_s' have 200 Hz"));
  EXPECT_EQ(readText(text, byOption("--sampling-rate", "200.0")).size(), 3U);
}

TEST(Advice, MergesRowsThatRepeat) {
  const log::Log log = readText("time_s,displacement_mm\n0,1\n1,2\n1,2\n2,3\n");
  EXPECT_EQ(log.size(), 3U);
  EXPECT_THAT(log.notes, ::testing::ElementsAre(HasSubstr("1 row that repeats the preceding row exactly")));
}

TEST(Advice, BridgesALongerGap) {
  std::string text = "time_s,displacement_mm,force_N\n";
  for (int i = 0; i < 1000; ++i) {
    text += fmt::format("{:.3f},{},{}\n", 0.1 * i, i >= 500 && i < 508 ? "Overrun" : std::to_string(i), i);
  }
  const std::string error = refusalOf(text);
  EXPECT_THAT(error, HasSubstr(":502: displacement_mm: 'Overrun' is not a number"));
  EXPECT_EQ(readText(text, advised(error, "--bridge")).size(), 992U);
}

TEST(Advice, NamesTheSegments) {
  const std::string text = "time_s,displacement_mm\n0,1\n1,2\n\nSpecimen 2\ntime_s,displacement_mm\n0,3\n1,4\n";
  const std::string error = refusalOf(text);
  EXPECT_THAT(error, HasSubstr("the file contains 2 logs: lines 2 to 3, lines 7 to 8"));
  EXPECT_EQ(readText(text, advised(error, "--segment")).displacement[0], 1e-3);
  EXPECT_EQ(readText(text, byOption("--segment", "2")).displacement[0], 3e-3);
}

// In a file of LabVIEW the column X_Value is a time in seconds.
TEST(Advice, NamesTheSegmentsOfAFormatThatDefinesItsTime) {
  std::string text;
  for (int segment = 1; segment <= 2; ++segment) {
    text += "***End_of_Header***\nChannels\t2\nY_Unit_Label\tmm\tN\n***End_of_Header***\nX_Value\tTravel\tLoad\n";
    text += fmt::format("0.0\t{0}\t1.5\n0.5\t{0}\t2.5\n\n", segment);
  }
  const std::string error = refusalOf(text);
  EXPECT_THAT(error, HasSubstr("the file contains 2 logs: lines 6 to 7, lines 14 to 15"));
  const log::Log log = readText(text, byOption("--segment", "2"));
  EXPECT_EQ(log.stamp[1], 500000000);
  EXPECT_EQ(log.displacement[0], 2e-3);
  EXPECT_THAT(log.notes, ::testing::Contains("column 'X_Value' is read in s; --unit selects another unit"));
}

TEST(Advice, ALongRowOfGroupsIsNoNumber) {
  std::string groups = "1";
  for (int i = 0; i < 15000; ++i) {
    groups += " 000";
  }
  EXPECT_THAT(refusalOf("time_s;displacement_mm;force_N\n0;1,5;2,5\n1;1,5;" + groups + "\n2;1,5;2,5\n"),
              HasSubstr("is not a number"));
}

TEST(Units, BehindNumbersMakeNoHeader) {
  EXPECT_THAT(refusalOf("time;displacement;force\n0.0 s;1.5 mm;8 N\n0.1 s;1.6 mm;9 N\n0.2 s;1.7 mm;9 N\n"),
              HasSubstr(":1: column 'displacement' has no unit; accepted: --unit displacement=UNIT"));
}

TEST(Units, AreUnderstoodOrRefusedByName) {
  const auto at = [](const std::string& column, const std::string& value = "1") {
    return "time_s," + column + "\n0," + value + "\n1,2\n";
  };
  EXPECT_EQ(readText(at("Displacement [MM]")).displacement[0], 1e-3);
  EXPECT_THAT(refusalOf(at("Displacement [Mm]")), HasSubstr("unit 'Mm' is 1e+06 m (did you mean 'mm'?)"));
  EXPECT_THAT(refusalOf(at("Displacement [steps]")), HasSubstr("unit 'steps' is unknown"));
  for (const auto& [unit, newton] :
       {std::pair("KN", 1e3), {"lbs", 4.4482216152605}, {"kgf", 9.80665}, {"kp", 9.80665}}) {
    const log::Log log = readText(fmt::format("time_s,displacement_mm,Force [{}]\n0,1,1\n1,2,2\n", unit));
    EXPECT_NEAR(log.force[0], newton, 1e-12 * newton) << unit;
  }
  EXPECT_THAT(refusalOf("time_s,displacement_mm,Force [Nm]\n0,1,1\n1,2,2\n"), HasSubstr("'Nm'"));
  for (const char* unit : {"C", "deg C", "\u00b0C"}) {
    const log::Log log = readText(fmt::format("time_s,displacement_mm,Temperature [{}]\n0,1,20\n1,2,21\n", unit));
    EXPECT_EQ(log.temperature, (std::vector<double>{20.0, 21.0})) << unit;
  }
}

TEST(Columns, TakeAFactorAndASign) {
  const std::string text = "time_s,displacement_mm,cell\n0,1,1000\n1,2,-500\n";
  const log::Log log = readText(text, byColumns({"force=-0.001*cell"}, "force=kN"));
  EXPECT_DOUBLE_EQ(log.force[0], -1000.0);
  EXPECT_DOUBLE_EQ(readText(text, byColumns({"force=-cell"}, "force=N")).force[1], 500.0);
}

TEST(Header, TellsUnitsHoweverItsColumnsAreChosen) {
  const std::string rows = "0,1,2,\n1,2,3,\n";
  for (const char* header :
       {"Time (ms),Position (mm),Load (kN),\n", "Time,Position,Load,\nms,mm,kN,\n",
        "Time,Analog 1,Analog 2,\nms,Displacement (mm),Force (kN),\n", "Unit,mm,kN\nTime [ms],Position,Load,\n"}) {
    for (const auto& columns : {std::vector<std::string>{}, {"time=1", "displacement=2", "force=3"}}) {
      const log::Log log = readText(header + rows, byColumns(columns));
      EXPECT_EQ(log.stamp[1], 1000000) << header;
      EXPECT_DOUBLE_EQ(log.displacement[0], 1e-3) << header;
      EXPECT_DOUBLE_EQ(log.force[0], 2e3) << header;
    }
  }
}

TEST(Header, OfARowOfUnitsHasBracketsThatAreNoUnits) {
  const auto load = [](const std::string& name, const std::string& unit) {
    return "Time,Stroke," + name + "\ns,mm," + unit + "\n0,1,2\n0.1,2,3\n";
  };
  for (const char* name : {"Force (Ch 2)", "Force (A)", "Load (LVDT 1)", "Force"}) {
    for (const auto& columns : {std::vector<std::string>{}, {"time=1", "displacement=2", "force=3"}}) {
      EXPECT_DOUBLE_EQ(readText(load(name, "kN"), byColumns(columns)).force[0], 2e3) << name;
    }
  }
  EXPECT_DOUBLE_EQ(readText(load("Force (kN)", "KN")).force[0], 2e3);
  EXPECT_THAT(refusalOf(load("Force (N)", "kN")), HasSubstr("column 'Force (N)': the row of units states 'kN', but the "
                                                            "column's name states 'N'; accepted: --unit force=UNIT"));
  EXPECT_THAT(refusalOf("Time [s],Stroke [mm],Force (Ch 2)\n0,1,2\n0.1,2,3\n"), HasSubstr("unit 'Ch 2' is unknown"));
}

TEST(Header, ThatAnErrorListsStandsAboveTheNumbers) {
  const std::string preamble = "Specimen;A1\nWidth (mm);6\nThickness (mm);3\n";
  EXPECT_THAT(
      refusalOf(preamble + "Zeit;Kanal 1;Kanal 2\n0;1;2\n1;2;3\n"),
      HasSubstr(":4: there is no column of displacement; the header has 'Zeit', 'Kanal 1', 'Kanal 2'; accepted: "
                "displacement_<m|mm|um>, or --columns displacement=NAME"));
  EXPECT_THAT(refusalOf(preamble + "Zeit;Kanal 1;Kanal 2\ns;mm;V\n0;1;2\n1;2;3\n", byColumns({"force=4"})),
              HasSubstr(":4: "));
  const std::string channels = "Units,mm,kN\nDisp_1,Load_1\n0,1\n1,2\n";
  EXPECT_THAT(refusalOf(channels),
              HasSubstr("there is no column of time; the header has 'Disp_1 [mm]', 'Load_1 [kN]'"));
  EXPECT_DOUBLE_EQ(readText(channels, byOption("--sampling-rate", "10")).force[1], 2e3);
  EXPECT_THAT(refusalOf("Time [s],Strain [%],Stress [MPa]\n0,1,2\n1,2,3\n"),
              HasSubstr("'Strain [%]', 'Stress [MPa]': a quantity of the material, from which the shape (area, "
                        "height) gives a stiffness"));
  EXPECT_THAT(refusalOf("%time,field.displacement\n1700000000000000000,1\n1700000000005000000,2\n",
                        byColumns({"displacement=field.displacement"}, "displacement=m")),
              HasSubstr("accepted: --unit time=ns"));
}

// Some logs repeat the header for each buffer. They are one log if the time continues with the same step, and several
// logs if the time restarts or pauses.
TEST(Segments, AreNoneWhereAHeaderRepeatsAndTimeContinues) {
  const std::string head = "Running Time\tAxial Displacement\tAxial Force\nSec\tmm\tkN\n";
  const auto rows = [](int first, int count) {
    std::string text;
    for (int i = first; i < first + count; ++i) {
      text += fmt::format("{:.3f}\t{}\t{}\n", 0.005 * i, i, 2 * i);
    }
    return text;
  };
  const std::string buffer = "\nData Acquisition\tTime:\t1.0\tSec\n" + head;
  const std::string text = head + rows(0, 50) + buffer + rows(50, 50) + buffer + rows(100, 1);
  for (const char* segment : {"", "all", "1"}) {
    const log::Log log = readText(text, byOption("--segment", segment));
    ASSERT_EQ(log.size(), 101U) << segment;
    EXPECT_DOUBLE_EQ(log.force[100], 2e5);
    EXPECT_EQ(log.stamp[100], 500000000);
    EXPECT_THAT(log.notes.back(),
                HasSubstr("the header is repeated 2 times while time continues, first in line 55: read as one log"));
  }
  for (const int first : {0, 53}) {
    EXPECT_THAT(refusalOf(head + rows(0, 50) + buffer + rows(first, 50)), HasSubstr("the file contains 2 logs"))
        << first;
  }
  EXPECT_EQ(readText(head + rows(0, 50) + buffer + rows(52, 50)).size(), 100U);
  const std::string plain = "Time [s]\tTravel [mm]\n0\t1\n1\t2\n2\t3\n";
  EXPECT_EQ(readText(plain + "Buffer\t2\t0\nTime [s]\tTravel [mm]\n3\t4\n").size(), 4U);
  const std::string newtons = "Running Time\tAxial Displacement\tAxial Force\nSec\tmm\tN\n";
  EXPECT_THAT(refusalOf(head + rows(0, 50) + "\n" + newtons + rows(50, 50)), HasSubstr("the file contains 2 logs"));
}

TEST(Rows, OfStatisticsBelowTheDataAreLeftOut) {
  const std::string data = "Time [s]\tTravel [mm]\tForce [N]\n0\t1\t2\n1\t2\t3\n2\t3\t4\n";
  for (const char* blank : {"", "\n"}) {
    const log::Log log = readText(data + blank + "Min\t-2.0\t-2700\nMax:\t2.0\t2700\nMittelwert\t0\t0.1\n");
    EXPECT_EQ(log.size(), 3U);
    EXPECT_THAT(log.notes.back(), HasSubstr("3 rows of statistics below the data"));
  }
  EXPECT_THAT(refusalOf(data + "Min\t-2.0\t-2700\n3\t1\t2\n"), HasSubstr(":5: data follow this row of statistics"));
  EXPECT_THAT(refusalOf(data + "end of test\t1\t2\n"), HasSubstr("'end of test' is not a number"));
  // Words that appear in every row do not mark rows of statistics.
  EXPECT_EQ(readText("Peak,time_s,displacement_mm\nmax,0,1\nmin,1,-1\nmax,2,1\n").size(), 3U);
}

TEST(Numbers, HaveSignsApartFromTheirDigits) {
  for (const char* text : {"Time [s];Weg [mm];Kraft [N]\n0,0;+ 0,5;- 6,25\n0,1;- 1,5;+ 7,5\n",
                           "time_s,displacement_mm,force_N\n0.0,+ 0.5,- 6.25\n0.1,- 1.5,+ 7.5\n"}) {
    const log::Log log = readText(text);
    EXPECT_DOUBLE_EQ(log.displacement[1], -1.5e-3);
    EXPECT_DOUBLE_EQ(log.force[0], -6.25);
  }
}

// The column names are Japanese for "time", "displacement" and "load" in Shift-JIS.
TEST(Names, OfJapaneseInstrumentsAreShownAsTheyAre) {
  const std::string text = "\x8E\x9E\x8A\xD4[s],\x95\xCF\x88\xCA[mm],\x89\xD7\x8F\x64[N]\n0,1,2\n1,2,3\n";
  EXPECT_THAT(readText(text).notes.front(),
              HasSubstr("displacement from '\u5909\u4f4d[mm]', force from '\u8377\u91cd[N]'"));
}

TEST(Times, AreReadWithZoneMidnightAndDays) {
  const auto stampsOf = [](const std::string& first, const std::string& second) {
    const log::Log log = readText("Time;Travel [mm]\n" + first + ";1\n" + second + ";2\n", {});
    return log.stamp[1] - log.stamp[0];
  };
  EXPECT_EQ(stampsOf("23:59:59.5", "00:00:00,25"), 750000000);
  EXPECT_EQ(stampsOf("12.03.2025 14:31:07,123", "12.03.2025 14:31:07,128"), 5000000);
  EXPECT_EQ(stampsOf("2025-03-12T14:31:07+01:00", "2025-03-12T13:31:08Z"), 1000000000);
  EXPECT_EQ(stampsOf("2024-02-28 23:59:59", "2024-03-01 00:00:00"), 86401000000000);  // 2024 is a leap year
  EXPECT_EQ(stampsOf("11:59:59 AM", "12:00:00 PM"), 1000000000);
  EXPECT_NEAR(static_cast<double>(stampsOf("45975.5", "45975.500011574")), 1e9,
              1e5);  // one second as a fraction of a spreadsheet's day
  EXPECT_THAT(refusalOf("Time;Travel [mm]\n11/12/2025 23:59:59;1\n12/12/2025 00:00:00;2\n"), HasSubstr("ISO 8601"));
  EXPECT_THAT(refusalOf("Time;Travel [mm]\n1;1\n2;2\n"), HasSubstr("--unit time=UNIT"));
}

// Files of LabVIEW itself have a last column of comments, which is empty in most rows.
TEST(Dialects, OfLabViewHaveCommentsBehindTheRows) {
  const std::string preamble =
      "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\n***End_of_Header***\t\n\t\nChannels\t2\t\t\n"
      "Y_Unit_Label\tmm\tN\t\nX0\t0.0\t0.0\t\n***End_of_Header***\t\t\t\n";
  for (const char* rows : {"0.0\t1.0\t2.0\n0.1\t1.5\t3.0\n", "0.0\t1.0\t2.0\tstart\n0.1\t1.5\t3.0\n",
                           "0.0\t1.0\t2.0\t\n0.1\t1.5\t3.0\tthe end\n"}) {
    const log::Log log = readText(preamble + "X_Value\tPosition\tLoad\tComment\n" + rows, {}, "log.lvm");
    EXPECT_EQ(log.stamp, (std::vector<std::int64_t>{0, 100000000})) << rows;
    EXPECT_DOUBLE_EQ(log.displacement[1], 1.5e-3);
    EXPECT_EQ(log.force[1], 3.0);
  }
}

TEST(Dialects, OfTimeTellItsUnitBehindTheName) {
  const std::map<std::string, std::int64_t> units = {
      {"ns", 1}, {"us", 1000}, {"min", 60000000000}, {"h", 3600000000000}};
  for (const auto& [unit, nanoseconds] : units) {
    EXPECT_EQ(readText("time_" + unit + ",displacement_mm,force_N\n0,0,0\n2,1,1\n").stamp.back(), 2 * nanoseconds)
        << unit;
  }
}

TEST(Dialects, OfDatesHaveDaysThatThereAre) {
  const auto refusal = [](const std::string& day) {
    return refusalOf("Zeit;Weg [mm];Kraft [N]\n" + day + " 10:00:00;0;0\n" + day + " 10:00:01;1;1\n");
  };
  for (const char* day : {"31.01.2025", "29.02.2024", "2025-12-31", "28.02.1900"}) {
    EXPECT_EQ(refusal(day), "");
  }
  for (const char* day : {"31.02.2025", "29.02.2025", "31.04.2025", "2025-06-31", "29.02.1900", "32.01.2025"}) {
    EXPECT_THAT(refusal(day), HasSubstr("is no date of the calendar; accepted: a day from 1900 to 2200")) << day;
  }
}

TEST(Dialects, OfNumbersEndWhereTheirSquaresWould) {
  for (const char* row : {"1,1e31,0", "1,0,1e308", "1,0,-1e31"}) {
    EXPECT_THAT(refusalOf(std::string("time_s,displacement_m,force_N\n0,0,0\n") + row + "\n"),
                ::testing::AllOf(HasSubstr(":3: "), HasSubstr("out of range; accepted: at most 1e+30")));
  }
}

}  // namespace
}  // namespace rubber_suspension
