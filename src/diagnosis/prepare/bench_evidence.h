// Evidence for the verdict check_bench: logs with a wrong sign, unit, column or component, as recorded and corrected.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::prepare {

/// A log and the force of the configured component on its displacement [N].
struct ComparedLog {
  log::Record record;
  Eigen::VectorXd simulated;
};

/// A log with a fatal finding.
struct CheckedLog {
  ComparedLog as_recorded;
  std::string correction;  ///< proposed by the finding; empty if there is none
  std::optional<ComparedLog> corrected;
};

}  // namespace rubber_suspension::diagnosis::prepare

namespace rubber_suspension::diagnosis {

/// Logs with a fatal finding, for figures. Declared in diagnosis.h.
struct BenchEvidence {
  std::vector<prepare::CheckedLog> logs;
};

}  // namespace rubber_suspension::diagnosis

namespace rubber_suspension::diagnosis::prepare {

/// Returns the first three logs with a fatal finding that can be simulated, without those that are too short.
BenchEvidence benchEvidence(const std::vector<element::ElementDescription>& elements,
                            const std::vector<log::Record>& records,
                            const std::vector<measurement::RigFinding>& findings);

/// Returns the diagnosis check_bench, with the first fatal finding as its reason.
Diagnosis refused(const io::ComponentDescription& component, std::vector<measurement::RigFinding> findings);

}  // namespace rubber_suspension::diagnosis::prepare
