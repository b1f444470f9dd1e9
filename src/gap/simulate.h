// Force of elements over prepared records, for comparison with the measured force.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::gap {

/// Force of each record [N].
using Forces = std::vector<Eigen::VectorXd>;

/// Displacement of a record that drives a component.
using Drive = std::function<Eigen::VectorXd(const PreparedRecord&)>;

/// Returns the force of one component over records in the order of their recording [N]. It relaxes between records,
/// unless a lead-in continues the one before, and is driven by the records' displacement or that of `drive`.
Forces simulate(const std::vector<element::ElementDescription>& elements, const std::vector<PreparedRecord>& records,
                const Drive& drive = {});

/// Returns the displacement as recorded, which drives `replay` and the node.
Eigen::VectorXd asRecorded(const log::Record& record);

/// Simulates each record on a new component at rest; with the displacement as recorded, as `replay` and the node do.
Forces simulateEach(const std::vector<element::ElementDescription>& elements,
                    const std::vector<PreparedRecord>& records, const Drive& drive = asRecorded);

}  // namespace rubber_suspension::gap
