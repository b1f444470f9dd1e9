// Force of elements over prepared records: what fits and diagnosis compare with the measurement.
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

/// Force of a component over records in the order of their recording on one component [N]: between two of them it
/// relaxes, but for what leads into excerpts. It is driven by the records' displacement unless `drive` gives another.
Forces simulate(const std::vector<element::ElementDescription>& elements, const std::vector<PreparedRecord>& records,
                const Drive& drive = {});

/// The displacement as recorded, which drives `replay` and the node.
Eigen::VectorXd asRecorded(const log::Record& record);

/// Each record on a new component at rest; from the displacement as recorded it is what `replay` and the node compute.
Forces simulateEach(const std::vector<element::ElementDescription>& elements,
                    const std::vector<PreparedRecord>& records, const Drive& drive = asRecorded);

}  // namespace rubber_suspension::gap
