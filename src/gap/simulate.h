// Simulates elements over prepared records, for comparison with the measured force.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::gap {

/// One force per record [N].
using Forces = std::vector<Eigen::VectorXd>;

/// Returns the displacement that drives a component over a record.
using Drive = std::function<Eigen::VectorXd(const PreparedRecord&)>;

/// Returns the force of one component over records in the order of their recording [N]. The component relaxes between
/// records, unless the lead-in of a record continues the previous record. It is driven by the displacement of the
/// records, or by `drive` if that is given.
Forces simulate(const std::vector<element::ElementDescription>& elements, const std::vector<PreparedRecord>& records,
                const Drive& drive = {});

/// Returns the displacement as recorded, which `replay` and the node use.
Eigen::VectorXd asRecorded(const log::Record& record);

/// Simulates each record on a new component at rest, by default with the displacement as recorded.
Forces simulateEach(const std::vector<element::ElementDescription>& elements,
                    const std::vector<PreparedRecord>& records, const Drive& drive = asRecorded);

}  // namespace rubber_suspension::gap
