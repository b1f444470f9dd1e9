// The verdict check_bench and its figures: logs with a wrong sign, unit, column or component, as they are and
// corrected.
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
  std::string correction;  ///< that the finding proposes; empty where it proposes none
  std::optional<ComparedLog> corrected;
};

}  // namespace rubber_suspension::diagnosis::prepare

namespace rubber_suspension::diagnosis {

/// A type that a public header declares.
struct BenchEvidence {
  std::vector<prepare::CheckedLog> logs;
};

}  // namespace rubber_suspension::diagnosis

namespace rubber_suspension::diagnosis::prepare {

/// Evidence from the first logs with a fatal finding that can be simulated.
BenchEvidence benchEvidence(const std::vector<element::ElementDescription>& elements,
                            const std::vector<log::Record>& records,
                            const std::vector<measurement::RigFinding>& findings);

/// The diagnosis of a measurement with a wrong sign, unit, column or component: check_bench, by the first fatal
/// finding.
Diagnosis refused(const io::ComponentDescription& component, std::vector<measurement::RigFinding> findings);

}  // namespace rubber_suspension::diagnosis::prepare
