// Comparison of the forces of a bench with a reference, with a report in the XML format of GoogleTest for rostest.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/agreement.h"
#include "ros_interface/log_player.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::ros_interface {

struct TestCase {
  std::string name;  ///< one word
  bool passed = false;
  std::string message;    ///< the numbers of the result, or the reason of a failure
  double duration = 0.0;  ///< [s]
};

std::string testReportXml(const std::string& suite, const std::vector<TestCase>& cases);

/// Returns the path from an option `xml:PATH`, which rostest passes to tests. Throws std::invalid_argument.
std::string testReportPath(const std::string& gtest_output);

/// Writes the report. Throws std::runtime_error.
void writeTestReport(const std::string& path, const std::string& suite, const std::vector<TestCase>& cases);

/// A reference force with its name in messages, such as "the force measured in track.csv".
struct ForceReference {
  std::string name;
  std::vector<double> force;  ///< [N], one per sample
};

/// Returns the measured force of the log. Throws std::invalid_argument if it has none.
ForceReference measuredReference(const log::Log& log);

/// Returns the force of the component, simulated offline for the log. Throws as simulateLog() does.
ForceReference simulatedReference(const component::Component& component, const log::Log& log,
                                  const std::string& config);

/// Checks that every sample of the log had exactly one force.
TestCase checkAnswers(const std::string& component, const log::Log& log, const PlayResult& result);

/// Compares the bench's forces with the reference, without the first `skip` seconds of the log. Returns nullopt if a
/// force is missing. Throws std::invalid_argument if no samples remain or the reference is constant there.
std::optional<gap::Agreement> compareForces(const log::Log& log, const ForceReference& reference,
                                            const PlayResult& result, double skip);

/// Checks that the gap to the reference is at most `tolerance`. Fails if a force is missing or not finite.
TestCase checkForces(const log::Log& log, const ForceReference& reference, const PlayResult& result,
                     const std::optional<gap::Agreement>& agreement, double tolerance);

/// Returns a figure of the force of the bench and the reference force over time and displacement, and of their
/// difference. Every sample must have a force.
io::Figure forceFigure(const std::string& component, const log::Log& log, const ForceReference& reference,
                       const PlayResult& result);

}  // namespace rubber_suspension::ros_interface
