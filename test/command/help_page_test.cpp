// From the text of --help to man pages, completion and the list of commands.
#include "command/help_page.h"

#include <gmock/gmock.h>

namespace rubber_suspension {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const char* const kHelp = R"(Simulates a component on a log. Nothing else; a line
goes here.

Parameters:
  ~max_gap            longest time
Usage: replay [OPTIONS] [page]

Positionals:
  page                      page to print (a, b; default
                            a)

Options:
  -h,--help                 Print this help message and exit
  --config FILE             component file (required)
  --connect-timeout SECONDS
                            time to wait for the node (0.01 to 1e+06;
                            default 300)
  --components COUNT ...    numbers of components
  --output FOLDER           folder of the report

Examples:
  # A log
  rosrun rubber_suspension replay --log a.csv \
      --output b.csv
)";

command::HelpPage page() { return command::parseHelp("replay", kHelp); }

TEST(ParseHelp, FindsEveryPart) {
  const command::HelpPage parsed = page();
  EXPECT_EQ(parsed.firstSentence(), "Simulates a component on a log.");
  EXPECT_EQ(parsed.usage, "[OPTIONS] [page]");
  ASSERT_EQ(parsed.options.size(), 6u);
  EXPECT_THAT(parsed.options[0].names, ElementsAre("page"));
  EXPECT_EQ(parsed.options[0].text, "page to print (a, b; default a)");
  EXPECT_THAT(parsed.options[1].names, ElementsAre("-h", "--help"));
  EXPECT_EQ(parsed.options[1].placeholder, "");
  EXPECT_EQ(parsed.options[2].placeholder, "FILE");
  EXPECT_THAT(parsed.options[3].names, ElementsAre("--connect-timeout"));
  EXPECT_EQ(parsed.options[3].placeholder, "SECONDS");
  EXPECT_EQ(parsed.options[3].text, "time to wait for the node (0.01 to 1e+06; default 300)");
  EXPECT_EQ(parsed.options[4].placeholder, "COUNT ...");
  EXPECT_EQ(parsed.options[5].text, "folder of the report");
  EXPECT_THAT(parsed.examples,
              ElementsAre("  # A log", "  rosrun rubber_suspension replay --log a.csv \\", "      --output b.csv"));
}

TEST(ManPage, HasTheOptionsInRoff) {
  const std::string text = command::manPage(page(), "1.2.3");
  EXPECT_THAT(text, HasSubstr(".TH RUBBER\\-SUSPENSION\\-REPLAY 1 \"\" \"rubber_suspension 1.2.3\""));
  EXPECT_THAT(text, HasSubstr("rubber\\-suspension\\-replay \\- simulates a component on a log\n"));
  EXPECT_THAT(text, HasSubstr(".TP\n\\fB\\-\\-config\\fR \\fIFILE\\fR\ncomponent file (required)\n"));
  EXPECT_THAT(text, HasSubstr(".nf\n  ~max_gap            longest time\n.fi\n"));
  EXPECT_THAT(text, HasSubstr(".SH EXAMPLES\n.nf\n  # A log\n"));
}

TEST(ManPage, TakesNoTextForARequest) {
  EXPECT_THAT(command::manPage(command::parseHelp("x", "Does.\n.so /etc/passwd \\n\nUsage: x\n"), "1"),
              HasSubstr("\n\\&.so /etc/passwd \\en\n"));
}

TEST(CommandList, HasThePhraseOfEachCommand) {
  EXPECT_EQ(command::commandList({page()}), "  replay            simulates a component on a log\n");
}

TEST(BashCompletion, KnowsOptionsFilesAndFolders) {
  EXPECT_THAT(command::bashCompletion({page()}),
              HasSubstr("    replay) options=\"--help --config --connect-timeout --components --output\" "
                        "files=\"--config\" folders=\"--output\" ;;\n"));
}

}  // namespace
}  // namespace rubber_suspension
