// Checks the forces of a bench: a log goes in over the topics, its forces are compared with a reference; and the report
// of it in the XML format of GoogleTest, which rostest and rosunit read.
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

/// The reference, for messages: "the force measured in track.csv".
struct ForceReference {
  std::string name;
  std::vector<double> force;  ///< [N], one per sample
};

/// The force that the log has measured. Throws std::invalid_argument where it has none.
ForceReference measuredReference(const log::Log& log);

/// The force that a component file gives for the log, offline; a new component. Throws as simulateLog does.
ForceReference simulatedReference(const component::Component& component, const log::Log& log,
                                  const std::string& config);

/// Checks that every sample of the log had exactly one force.
TestCase checkAnswers(const std::string& component, const log::Log& log, const PlayResult& result);

/// Compares the bench's forces with the reference, without the first `skip` seconds of the log; nullopt if a force is
/// missing. Throws std::invalid_argument if no samples remain or the reference is constant there.
std::optional<gap::Agreement> compareForces(const log::Log& log, const ForceReference& reference,
                                            const PlayResult& result, double skip);

/// Checks that the gap to the reference is at most `tolerance`. A force that is missing or not finite fails.
TestCase checkForces(const log::Log& log, const ForceReference& reference, const PlayResult& result,
                     const std::optional<gap::Agreement>& agreement, double tolerance);

/// Forces of bench and reference over time and displacement, and their difference. Every sample has to have its force.
io::Figure forceFigure(const std::string& component, const log::Log& log, const ForceReference& reference,
                       const PlayResult& result);

}  // namespace rubber_suspension::ros_interface
