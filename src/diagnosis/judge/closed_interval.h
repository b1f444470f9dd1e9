// How sure it is which part of the gap a model closes.
#pragma once

#include <array>
#include <vector>

#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {

/// 95 % interval of the closed fraction by resampling the parts of the logs, paired, and the noise floor. The same
/// numbers at every call with the same seed.
std::array<double, 2> closedInterval(const std::vector<gap::PartError>& before,
                                     const std::vector<gap::PartError>& after, double floor, int resamplings,
                                     unsigned seed);

}  // namespace rubber_suspension::diagnosis
