// The result of a test node in the XML format of GoogleTest, which rostest and rosunit read.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// One thing that was checked.
struct TestCase {
  std::string name;  ///< one word
  bool passed = false;
  std::string message;    ///< what was found, with the figure; the reason where it failed
  double duration = 0.0;  ///< [s]
};

/// The report of one suite as XML.
std::string testReportXml(const std::string& suite, const std::vector<TestCase>& cases);

/// The path in an option of the form that rostest hands to its tests, `xml:PATH`.
/// Throws std::invalid_argument that says what is accepted.
std::string testReportPath(const std::string& gtest_output);

/// Write the report. Throws std::runtime_error.
void writeTestReport(const std::string& path, const std::string& suite, const std::vector<TestCase>& cases);

}  // namespace rubber_suspension::ros_interface
