// The report of a test node has the format of rostest. The same kind of parser as in rostest reads it back.
#include "support/test.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include "ros_interface/force_check.h"

namespace rubber_suspension {
namespace {

boost::property_tree::ptree parsed(const std::vector<ros_interface::TestCase>& cases) {
  std::istringstream text(ros_interface::testReportXml("bench", cases));
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(text, tree);
  return tree.get_child("testsuites.testsuite");
}

TEST(TestReport, CountsAndNamesWhatWasChecked) {
  const auto suite = parsed({{"first", true, "gap 0.01", 0.5}, {"second", false, "gap 0.2", 0.25}});
  EXPECT_EQ(suite.get<std::string>("<xmlattr>.name"), "bench");
  EXPECT_EQ(suite.get<int>("<xmlattr>.tests"), 2);
  EXPECT_EQ(suite.get<int>("<xmlattr>.failures"), 1);
  EXPECT_EQ(suite.get<double>("<xmlattr>.time"), 0.75);
  EXPECT_EQ(suite.count("testcase"), 2U);
}

TEST(TestReport, OnlyWhatFailedHasAFailure) {
  const auto suite = parsed({{"first", true, "gap 0.01", 0.5}, {"second", false, "gap 0.2", 0.25}});
  for (const auto& [tag, test] : suite) {
    if (tag == "testcase") {
      EXPECT_EQ(test.count("failure"), test.get<std::string>("<xmlattr>.name") == "second" ? 1U : 0U);
    }
  }
  EXPECT_EQ(suite.get<std::string>("testcase.system-out"), "gap 0.01");
}

TEST(TestReport, KeepsCharactersThatXmlUsesItself) {
  const std::string message = "gap > 0.1 in <\"a & b\">";
  const auto suite = parsed({{"forces", false, message, 0.0}});
  EXPECT_EQ(suite.get<std::string>("testcase.failure"), message);
  EXPECT_EQ(suite.get<std::string>("testcase.failure.<xmlattr>.message"), message);
}

TEST(TestReport, TakesThePathFromTheOptionOfRostest) {
  EXPECT_EQ(ros_interface::testReportPath("xml:/tmp/a:b.xml"), "/tmp/a:b.xml");
  EXPECT_THROW(ros_interface::testReportPath("xml:"), std::invalid_argument);
  EXPECT_THROW(ros_interface::testReportPath("json:/tmp/a"), std::invalid_argument);
  EXPECT_THROW(ros_interface::testReportPath(""), std::invalid_argument);
}

TEST(TestReport, SaysWhereItCannotBeWritten) {
  EXPECT_NE(messageOf<std::runtime_error>([&] {
              ros_interface::writeTestReport("/nowhere/at/all.xml", "bench", {});
            }).find("/nowhere/at/all.xml"),
            std::string::npos);
}

}  // namespace
}  // namespace rubber_suspension
