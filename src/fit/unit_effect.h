// What an atom does to logs at scale 1, where that does not depend on the others.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/fit/candidate.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// Of an additive atom the force that it adds [N], of a softening one the share of the specimen's force that it takes.
std::vector<Eigen::VectorXd> unitEffect(const Atom& atom, const std::vector<log::Record>& records);

}  // namespace rubber_suspension::fit
