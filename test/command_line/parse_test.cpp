// Command lines are read by a table of options: values of the variables, refusals, and the help that the table gives.
#include "command_line/parse.h"

#include "command_line/command.h"
#include "support/test.h"

namespace rubber_suspension::command_line {
namespace {

struct Values {
  std::string task = "run";
  std::string forces = "library";
  std::vector<std::string> logs;
  bool quick = false;
  int threads = 2;
  std::vector<int> components = {1, 10};
  std::uint64_t samples = 0;
  double speed = 1.5;
  double amplitude = 0.0;
  std::optional<double> frequency;
  std::vector<double> range;
  double share = 0.1;
  bool echo = false;

  OptionTable table() {
    OptionTable options = {
        Option("task", task, "", "work to do").oneOf({"run", "plan"}),
        Option("--forces", forces, "NAME", "where the forces come from").oneOf({"library", "topics"}),
        Option("--log", logs, "FILE", "logs to read"),
        Option("--quick", quick, "less of everything"),
        Option("--threads", threads, "COUNT", "number of threads").within(1, 64),
        Option("--components", components, "COUNT", "numbers of components").within(1, 500),
        Option("--samples", samples, "COUNT", "samples; all if absent").within(10, 1e11).rare(),
        Option("--speed", speed, "M/S", "speed of the vehicle; constant").within(0.1, 100000),
        Option("--amplitude", Quantity{&amplitude, "m"}, "METRES", "amplitude, such as '2 mm'"),
        Option("--frequency", Quantity{&frequency, "Hz"}, "HZ", "frequency"),
        Option("--range", Quantity{&range, "m"}, "METRES", "ends of a range").values(2, 2),
        Option("--share", Quantity{&share, "1", element::Range::closed(0.01, 1.0), "a share from 1 to 100 %"}, "SHARE",
               "share of the force")
            .defaultText("10 %"),
        Option("--echo", echo, "for the command itself").hidden()};
    options.needs({"--speed"}, {"--forces topics"}).excludes({"--log", "--samples"}, {"--quick"});
    return options.needs({"--range"}, {"--amplitude", "--frequency"}).needs({"--share"}, {"task plan"});
  }
};

const Command kCommand = {"try", "Tries a table of options.\n\nAnd more.", {{"Less", "--quick"}}};

Request parse(Values& values, std::vector<std::string> words) {
  words.insert(words.begin(), "try");
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  return parse(static_cast<int>(pointers.size()), pointers.data(), kCommand, values.table());
}

std::string refusal(const std::vector<std::string>& words) {
  Values values;
  return messageOf<UsageError>([&] { parse(values, words); });
}

TEST(Parse, FillsWhatTheTablePointsTo) {
  Values values;
  EXPECT_EQ(parse(values, {"plan", "--log", "a.csv", "b.csv", "--threads=3", "--components", "5", "7", "--samples",
                           "99000000000", "--forces", "topics", "--speed", "2.5", "--share", "5 %"}),
            Request::run);
  EXPECT_EQ(values.task, "plan");
  EXPECT_THAT(values.logs, ElementsAre("a.csv", "b.csv"));
  EXPECT_EQ(values.threads, 3);
  EXPECT_THAT(values.components, ElementsAre(5, 7));
  EXPECT_EQ(values.samples, 99000000000U);
  EXPECT_EQ(values.speed, 2.5);
  EXPECT_DOUBLE_EQ(values.share, 0.05);
  EXPECT_FALSE(values.quick);
}

TEST(Parse, KeepsWhatIsNotGiven) {
  Values values;
  EXPECT_EQ(parse(values, {}), Request::run);
  EXPECT_EQ(values.task, "run");
  EXPECT_THAT(values.components, ElementsAre(1, 10));
  EXPECT_FALSE(values.frequency);
  EXPECT_EQ(values.share, 0.1);
}

TEST(Parse, ReadsQuantitiesWithTheirUnits) {
  Values values;
  parse(values, {"--amplitude", "2 mm", "--frequency", "4", "--range", "1 mm", "1 cm"});
  EXPECT_DOUBLE_EQ(values.amplitude, 2e-3);
  EXPECT_EQ(values.frequency, 4.0);
  EXPECT_THAT(values.range, ElementsAre(1e-3, 1e-2));
}

TEST(Parse, RefusesValuesThatAreNotAdmissible) {
  EXPECT_EQ(refusal({"--threads", "65"}),
            "--threads: '65' is not valid; accepted: a whole number from 1 to 64 (see --help)");
  EXPECT_THAT(refusal({"--threads", "two"}), HasSubstr("'two' is not valid; accepted: a whole number from 1 to 64"));
  EXPECT_THAT(refusal({"--threads", "1.5"}), HasSubstr("'1.5' is not valid; accepted: a whole number"));
  EXPECT_THAT(refusal({"--forces", "topics", "--speed", "nan"}),
              HasSubstr("'nan' is not valid; accepted: a number from 0.1"));
  EXPECT_THAT(refusal({"--forces", "fields"}), HasSubstr("fields not in {library,topics}"));
  EXPECT_EQ(refusal({"--amplitude=-2 mm"}), "--amplitude: '-2 mm' is out of range; accepted: greater than 0 mm");
  EXPECT_THAT(refusal({"--amplitude", "2 kg"}), HasSubstr("--amplitude: '2 kg': "));
  EXPECT_THAT(refusal({"--amplitude", "two"}), HasSubstr("'two': not a number; accepted: greater than 0 m"));
  EXPECT_EQ(refusal({"plan", "--share", "0.1 %"}),
            "--share: '0.1 %' is out of range; accepted: a share from 1 to 100 %");
  EXPECT_THAT(refusal({"--amplitude", "1", "--range", "1 mm"}), HasSubstr("--range"));
}

TEST(Parse, RefusesOptionsWithoutEffect) {
  EXPECT_EQ(refusal({"--speed", "1"}), "--speed has no effect without --forces topics");
  EXPECT_EQ(refusal({"--log", "a", "--quick"}), "--log has no effect with --quick");
  EXPECT_EQ(refusal({"--samples", "10", "--quick"}), "--samples has no effect with --quick");
  EXPECT_EQ(refusal({"--range", "1", "2"}), "--range has no effect without --amplitude or --frequency");
  EXPECT_EQ(refusal({"run", "--share", "1"}), "--share has no effect on run");
}

TEST(Parse, RefusesBothOrNoneOfAlternatives) {
  std::string config;
  std::string sheet;
  OptionTable table = {Option("--config", config, "FILE", "component file"),
                       Option("--sheet", sheet, "FILE", "data sheet")};
  table.oneOf({"--config", "--sheet"});
  char name[] = "try";
  char* words[] = {name};
  EXPECT_THROW(parse(1, words, kCommand, table), UsageError);
}

TEST(Parse, NamesTheOptionThatWasMeant) {
  EXPECT_EQ(refusal({"--thread", "1"}),
            "no option --thread (did you mean --threads?); accepted: the options listed by --help");
  EXPECT_THAT(refusal({"--ech"}), Not(HasSubstr("echo")));
}

TEST(Parse, KnowsHelpAndVersionWhateverElseIsWrong) {
  Values values;
  EXPECT_EQ(parse(values, {"--help"}), Request::help);
  EXPECT_EQ(parse(values, {"--version"}), Request::version);
}

TEST(Help, ShowsRangesWordsAndDefaults) {
  Values values;
  const std::string help = helpText(kCommand, values.table(), HelpSize::all);
  EXPECT_THAT(help, HasSubstr("Tries a table of options.\n\nAnd more.\nUsage: try [OPTIONS] [task]\n"));
  EXPECT_THAT(help, HasSubstr("  task                      work to do (run, plan; default run)\n"));
  EXPECT_THAT(help, HasSubstr("  --log FILE ...            logs to read\n"));
  EXPECT_THAT(help, HasSubstr("  --threads COUNT           number of threads (1 to 64; default 2)\n"));
  EXPECT_THAT(help, HasSubstr("(1 to 500; default [1,10])"));
  EXPECT_THAT(help, HasSubstr("all if absent (10 to 100000000000)\n"));
  EXPECT_THAT(help, HasSubstr("(0.1 to 100000; default 1.5)"));
  EXPECT_THAT(help, HasSubstr("  --range METRES METRES     ends of a range\n"));
  EXPECT_THAT(help, HasSubstr("share of the force (default 10 %)\n"));
  EXPECT_THAT(help, Not(HasSubstr("--echo")));
}

TEST(Help, LeavesOutWhatIsRare) {
  Values values;
  const std::string help = helpText(kCommand, values.table(), HelpSize::screen);
  EXPECT_THAT(help, HasSubstr("Tries a table of options.\nUsage: "));
  EXPECT_THAT(help, HasSubstr("  --speed M/S               speed of the vehicle (0.1 to 100000; default 1.5)\n"));
  EXPECT_THAT(help, Not(HasSubstr("--samples COUNT")));
  EXPECT_THAT(help, HasSubstr("  With --help-all: --samples\n"));
  EXPECT_THAT(help, HasSubstr("\nExamples:\n  # Less\n  rosrun rubber_suspension try --quick\n"));
}

// runCommand() checks the files in the table of options, and returns the exit status.
TEST(RunCommand, ChecksTheFilesOfTheTableBeforeItRuns) {
  const auto status = [](const std::string& input, const std::string& output, bool forced) {
    std::string read;
    std::string written;
    OptionTable table = {Option("--log", read, "FILE", "log to read").reads(),
                         Option("--output", written, "FILE", "file to write").writes(io::file_kind::force_csv)};
    std::vector<std::string> words = {"try", "--log", input, "--output", output};
    if (forced) {
      words.emplace_back("--force");
    }
    std::vector<char*> pointers;
    for (std::string& word : words) {
      pointers.push_back(word.data());
    }
    return runCommand(static_cast<int>(pointers.size()), pointers.data(), kCommand, table, [] { return 0; });
  };
  const std::string source = TEST_DIR "/command_line/parse_test.cpp";
  EXPECT_EQ(status(source, "/dev/null", false), kSuccess);
  EXPECT_EQ(status(source, source, true), kWrongUsage) << "would be written over";
  EXPECT_EQ(status("other.csv", source, false), kWrongUsage) << "is of another kind";
  EXPECT_EQ(status("other.csv", source, true), kSuccess);
  EXPECT_EQ(status("other.csv", "", true), kWrongUsage) << "--force without effect";
}

}  // namespace
}  // namespace rubber_suspension::command_line
