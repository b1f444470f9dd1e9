// Collects evidence for the verdict check_bench: logs with a wrong sign, unit, column or component, and corrected logs.
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

/// A log, and the force [N] that the configured component has on the displacement of the log.
struct ComparedLog {
  log::Record record;
  Eigen::VectorXd simulated;
};

struct CheckedLog {
  ComparedLog as_recorded;
  std::string correction;  ///< text of the correction that the finding proposes; empty if it proposes none
  std::optional<ComparedLog> corrected;
};

}  // namespace rubber_suspension::diagnosis::prepare

namespace rubber_suspension::diagnosis {

/// Logs with a fatal finding, which the report draws. diagnosis.h declares the class.
struct BenchEvidence {
  std::vector<prepare::CheckedLog> logs;
};

}  // namespace rubber_suspension::diagnosis

namespace rubber_suspension::diagnosis::prepare {

/// Returns the first three logs that have a fatal finding other than "too short" and that can be simulated.
BenchEvidence benchEvidence(const std::vector<element::ElementDescription>& elements,
                            const std::vector<log::Record>& records,
                            const std::vector<measurement::RigFinding>& findings);

/// Returns a diagnosis with the verdict check_bench, whose sentence states the first fatal finding.
Diagnosis refused(const io::ComponentDescription& component, std::vector<measurement::RigFinding> findings);

}  // namespace rubber_suspension::diagnosis::prepare
