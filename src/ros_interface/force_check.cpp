// Checks the forces of a bench against a reference.
#include "ros_interface/force_check.h"

#include <fmt/format.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <sstream>

#include "element/refuse.h"
#include "log/new_file.h"
#include "rubber_suspension/gap/replay.h"

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

std::size_t firstCompared(const log::Log& log, double skip) {
  std::size_t first = 0;
  while (first < log.size() && log.duration(0, first) < skip) {
    ++first;
  }
  element::refuseIf(first + 2 > log.size(), "{}: no samples remain to be compared after {:g} s; the log lasts {:g} s",
                    log.name, skip, log.duration(0, log.size() - 1));
  return first;
}

}  // namespace

ForceReference measuredReference(const log::Log& log) {
  element::refuseIf(
      log.force.empty(),
      "{} has no measured force; accepted: a log with a measured force, or a component file as reference (--config)",
      log.name);
  return {"the force measured in " + log.name, log.force};
}

ForceReference simulatedReference(const component::Component& component, const log::Log& log,
                                  const std::string& config) {
  return {"the force of " + config, gap::simulateLog(component, log)};
}

TestCase checkAnswers(const std::string& component, const log::Log& log, const PlayResult& result) {
  TestCase test{"oneForceForEachDisplacement", result.exactlyOneEach(), "", result.duration};
  test.message = fmt::format("{}: {} of {} samples were answered, {} forces had unexpected stamps", component,
                             result.answered(), log.size(), result.unexpected);
  if (!test.passed && result.answered() == log.size() && result.unexpected == 0) {
    test.message += "; some samples were answered more than once";
  }
  return test;
}

std::optional<gap::Agreement> compareForces(const log::Log& log, const ForceReference& reference,
                                            const PlayResult& result, double skip) {
  if (result.answered() < log.size()) {
    return std::nullopt;
  }
  log::Log with_reference = log;
  if (reference.force != log.force) {  // the reference is simulated, so it has a force at each sample
    with_reference.force = reference.force;
    with_reference.counts.clear();
  }
  return gap::agreementOf(with_reference, result.totals(), firstCompared(log, skip));
}

TestCase checkForces(const log::Log& log, const ForceReference& reference, const PlayResult& result,
                     const std::optional<gap::Agreement>& agreement, double tolerance) {
  TestCase test{"forces", false, "", 0.0};
  if (!agreement) {
    test.message = fmt::format("the forces were not compared with {} because {} samples have no force", reference.name,
                               log.size() - result.answered());
    return test;
  }
  test.passed = agreement->gap <= tolerance;
  test.message = fmt::format(
      "gap of {:.6g} to {}, {} the limit {:g}; largest difference {:.6g} N, {:.6g} s after the start", agreement->gap,
      reference.name, test.passed ? "within" : "beyond", tolerance, agreement->peak, agreement->peak_time);
  return test;
}

io::Figure forceFigure(const std::string& component, const log::Log& log, const ForceReference& reference,
                       const PlayResult& result) {
  log::Log with_reference = log;
  with_reference.force = reference.force;
  return gap::replayFigure(component, with_reference, result.totals(), {"reference", "bench"});
}

std::string testReportXml(const std::string& suite, const std::vector<TestCase>& cases) {
  Tree document;
  Tree& tree = document.put("testsuites.testsuite", "");
  int failures = 0;
  double duration = 0.0;
  for (const TestCase& test : cases) {
    failures += test.passed ? 0 : 1;
    duration += test.duration;
    tree.add_child("testcase", caseTree(suite, test));
  }
  tree.put("<xmlattr>.name", suite);
  tree.put("<xmlattr>.tests", cases.size());
  tree.put("<xmlattr>.failures", failures);
  tree.put("<xmlattr>.errors", 0);
  tree.put("<xmlattr>.time", fmt::format("{:.3f}", duration));
  std::ostringstream text;
  boost::property_tree::write_xml(text, document, boost::property_tree::xml_writer_make_settings<std::string>(' ', 2));
  return text.str();
}

std::string testReportPath(const std::string& gtest_output) {
  const std::string format = "xml:";
  element::refuseIf(gtest_output.compare(0, format.size(), format) != 0 || gtest_output.size() == format.size(),
                    "--gtest_output={} is not supported; accepted: xml:FILE", gtest_output);
  return gtest_output.substr(format.size());
}

void writeTestReport(const std::string& path, const std::string& suite, const std::vector<TestCase>& cases) {
  log::writeNewFile(path, testReportXml(suite, cases));
}

}  // namespace rubber_suspension::ros_interface
