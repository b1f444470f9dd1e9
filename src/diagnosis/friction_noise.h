// What small reversals and the time before a log make of a model with Berg's friction.
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

/// What Berg's friction may add to each log that is slow and no drift, in the same units: frictionNoise(), and what it
/// forgets in the course of the log of where the component came from, be it the log's lowest or highest displacement.
/// What it does not forget is a zero.
std::vector<double> frictionDrift(const std::vector<element::ElementDescription>& elements,
                                  const std::vector<log::Record>& records);

}  // namespace rubber_suspension::diagnosis
