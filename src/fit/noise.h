// Whether a signal has noise worth asking how much.
#pragma once

#include <vector>

namespace rubber_suspension::fit {

/// noiseDeviation(signal) > deviation, in a fraction of the time where it is not.
bool noisierThan(const std::vector<double>& signal, double deviation);

}  // namespace rubber_suspension::fit
