// The result of a test node in the XML format of GoogleTest.
#include "ros_interface/test_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>
#include <stdexcept>

#include "log/new_file.h"

namespace rubber_suspension::ros_interface {
namespace {

using Tree = boost::property_tree::ptree;

Tree caseTree(const std::string& suite, const TestCase& test) {
  Tree tree;
  tree.put("<xmlattr>.name", test.name);
  tree.put("<xmlattr>.status", "run");
  tree.put("<xmlattr>.time", fmt::format("{:.3f}", test.duration));
  tree.put("<xmlattr>.classname", suite);
  if (test.passed) {
    tree.put("system-out", test.message);
  } else {
    Tree failure(test.message);
    failure.put("<xmlattr>.message", test.message);
    failure.put("<xmlattr>.type", "");
    tree.add_child("failure", failure);
  }
  return tree;
}

void putCounts(Tree& tree, const std::string& name, const std::vector<TestCase>& cases) {
  const auto failures = std::count_if(cases.begin(), cases.end(), [](const TestCase& test) { return !test.passed; });
  double duration = 0.0;
  for (const TestCase& test : cases) {
    duration += test.duration;
  }
  tree.put("<xmlattr>.name", name);
  tree.put("<xmlattr>.tests", cases.size());
  tree.put("<xmlattr>.failures", failures);
  tree.put("<xmlattr>.disabled", 0);
  tree.put("<xmlattr>.errors", 0);
  tree.put("<xmlattr>.time", fmt::format("{:.3f}", duration));
}

}  // namespace

std::string testReportXml(const std::string& suite, const std::vector<TestCase>& cases) {
  Tree suite_tree;
  putCounts(suite_tree, suite, cases);
  for (const TestCase& test : cases) {
    suite_tree.add_child("testcase", caseTree(suite, test));
  }
  Tree all;
  putCounts(all, "AllTests", cases);
  all.add_child("testsuite", suite_tree);
  Tree document;
  document.add_child("testsuites", all);
  std::ostringstream text;
  boost::property_tree::write_xml(text, document, boost::property_tree::xml_writer_make_settings<std::string>(' ', 2));
  return text.str();
}

std::string testReportPath(const std::string& gtest_output) {
  const std::string format = "xml:";
  if (gtest_output.compare(0, format.size(), format) != 0 || gtest_output.size() == format.size()) {
    throw std::invalid_argument(fmt::format("--gtest_output={}; accepted: xml:FILE", gtest_output));
  }
  return gtest_output.substr(format.size());
}

void writeTestReport(const std::string& path, const std::string& suite, const std::vector<TestCase>& cases) {
  log::writeNewFile(path, testReportXml(suite, cases));
}

}  // namespace rubber_suspension::ros_interface
