// Whether a signal has noise worth asking how much.
#pragma once

#include <vector>

namespace rubber_suspension::fit {

/// noiseStandardDeviation(signal) > standard_deviation, in a fraction of the time where it is not.
bool noisierThan(const std::vector<double>& signal, double standard_deviation);

}  // namespace rubber_suspension::fit
