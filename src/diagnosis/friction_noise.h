// The floor that small reversals set for a model with Berg's friction.
#pragma once

#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis {

/// What small reversals make of the force of Berg's friction, for each log, in units of the force's standard deviation;
/// zero for models without. It forgets all but the last reversal, so one that is missed, or taken where none was,
/// shifts all that follows: root mean square over some dead bands and draws of the sensor's noise. Other laws of a
/// model err by no more than the noise itself.
std::vector<double> frictionNoise(const std::vector<element::ElementDescription>& elements,
                                  const std::vector<log::Record>& records);

}  // namespace rubber_suspension::diagnosis
