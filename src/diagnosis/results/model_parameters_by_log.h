// Which model parameters each log alone would want.
#pragma once

#include <vector>

#include "fit/fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// By one Gauss-Newton step from the joint fit of the model parameters alone. Directions that a log hardly determines
/// stay near the joint fit: a prior of 10 % keeps them there.
std::vector<ParameterByLog> parametersByLog(const fit::Fitter& fitter, const fit::Fit& joint);

}  // namespace rubber_suspension::diagnosis
