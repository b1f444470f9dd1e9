// Logs as rigs and spreadsheets write them. For good_logs/X, the file X.expected has the options, the notes, and a line
// "stamp [ns], displacement [m], force [N]" per sample. For bad_logs/X.csv, the file X.error has the beginning of its
// error, without the file's name and the colon behind it.
#include <sys/stat.h>

#include "log/text.h"
#include "rubber_suspension/log/log.h"
#include "support/files.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

std::string nameOf(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = std::filesystem::path(info.param).stem().string();
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

struct Expected {
  log::LogFormat format;
  std::vector<std::string> notes;
  std::vector<std::int64_t> stamp;
  std::vector<double> displacement;
  std::vector<double> force;
};

// Parses options: words without a dash or an equals sign belong to the word before, as in "--columns time=a b".
log::LogFormat formatOf(const std::string& options) {
  std::vector<std::string> columns;
  std::string unit;
  double rate = 0.0;
  std::istringstream words(options);
  std::string option;
  for (std::string word; words >> word;) {
    if (word.compare(0, 2, "--") == 0) {
      option = word;
    } else if (option == "--unit") {
      unit += word + " ";
    } else if (option == "--sampling-rate") {
      rate = std::stod(word);
    } else if (!columns.empty() && word.find('=') == std::string::npos &&
               columns.back().find('=') != std::string::npos) {
      columns.back() += " " + word;
    } else {
      columns.push_back(word);
    }
  }
  return log::makeLogFormat(columns, unit, rate);
}

Expected readExpected(const std::string& path) {
  Expected expected;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, 8, "options ") == 0) {
      expected.format = formatOf(line.substr(8));
    } else if (line.compare(0, 5, "note ") == 0) {
      expected.notes.push_back(line.substr(5));
    } else {
      std::istringstream row(line);
      std::int64_t stamp = 0;
      double displacement = 0.0;
      std::string force;
      row >> stamp >> displacement >> force;
      expected.stamp.push_back(stamp);
      expected.displacement.push_back(displacement);
      if (force != "-") {
        expected.force.push_back(std::stod(force));
      }
    }
  }
  return expected;
}

void expectSame(const std::vector<double>& values, const std::vector<double>& expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_DOUBLE_EQ(values[i], expected[i]) << "sample " << i + 1;  // a conversion of units rounds several times
  }
}

class GoodLog : public ::testing::TestWithParam<std::string> {};

TEST_P(GoodLog, GivesItsNumbersAndSaysWhatItTookForWhat) {
  const Expected expected = readExpected(GetParam());
  ASSERT_FALSE(expected.stamp.empty());
  const std::string path = GetParam().substr(0, GetParam().size() - std::string(".expected").size());
  const log::Log log = log::readLog(path, expected.format);
  EXPECT_EQ(log.stamp, expected.stamp);
  expectSame(log.displacement, expected.displacement);
  expectSame(log.force, expected.force);
  EXPECT_EQ(log.notes, expected.notes);
  EXPECT_NO_THROW(log::checkLog(log));
}

INSTANTIATE_TEST_SUITE_P(Files, GoodLog, ::testing::ValuesIn(filesIn("log/good_logs", ".expected")), nameOf);

class BadLog : public ::testing::TestWithParam<std::string> {};

TEST_P(BadLog, IsRefusedWithItsError) {
  std::ifstream file(std::filesystem::path(GetParam()).replace_extension(".error"));
  std::string expected;
  std::getline(file, expected);
  ASSERT_FALSE(expected.empty()) << GetParam() << " does not say which error it has to give";
  const std::string text = messageOf<log::LogError>([&] { log::readLog(GetParam()); });
  EXPECT_THAT(text, StartsWith(GetParam() + ":" + expected));
  EXPECT_THAT(text, HasSubstr("accepted"));
  EXPECT_LT(text.size(), GetParam().size() + 1000);
  // Messages go to a terminal, so they must not contain control characters.
  EXPECT_TRUE(std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; })) << text;
  EXPECT_TRUE(log::isUtf8(text));
  EXPECT_EQ(log::oneLine(text), text);
}

INSTANTIATE_TEST_SUITE_P(Files, BadLog, ::testing::ValuesIn(filesIn("log/bad_logs", ".csv")), nameOf);

TEST(LogFiles, AreAllThere) {
  EXPECT_GE(filesIn("log/good_logs", ".expected").size(), 40u);
  EXPECT_GE(filesIn("log/bad_logs", ".csv").size(), 46u);
}

TEST(LogFiles, APipeWhoseOtherEndNobodyOpensIsRefused) {
  const TemporaryFile pipe("log.csv", "");
  std::filesystem::remove(pipe.path());
  ASSERT_EQ(mkfifo(pipe.path().c_str(), 0600), 0);
  const std::string message = messageOf<log::LogError>([&] { log::readLog(pipe.path()); });
  EXPECT_THAT(message, HasSubstr("is a pipe; accepted: a regular file"));
}

TEST(OneLine, EscapesWhatATerminalObeys) {
  EXPECT_EQ(log::oneLine("a\nb\tc\x1b[2J\x7f\x07"), "a b c\\x1b[2J\\x7f\\x07");
  EXPECT_EQ(log::oneLine("Pr\xc3\xbc"
                         "fstand \xc2\xb5m"),
            "Pr\xc3\xbc"
            "fstand \xc2\xb5m");
  EXPECT_EQ(log::oneLine("\xff\xc2\x9b\xe2\x80\xae"), "\\xff\\xc2\\x9b\\xe2\\x80\\xae");  // not UTF-8, CSI, override
  EXPECT_EQ(log::oneLine(std::string("\0", 1)), "\\x00");
}

TEST(Quoted, CutsBetweenCharacters) {
  std::string text(59, 'x');
  text += "\xc3\xbc\xc3\xbc";
  EXPECT_EQ(log::quoted(text), "'" + std::string(59, 'x') + "...'");
}

}  // namespace
}  // namespace rubber_suspension
