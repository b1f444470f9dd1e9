// Noise of one rig.
#include "diagnosis/rig_noise.h"

#include <algorithm>

#include "measurement/statistics.h"

namespace rubber_suspension::diagnosis {

double NoiseLimit::of(const log::Record& record) const { return std::max(force / record.force_deviation, share); }

NoiseLimit noiseLimit(const std::vector<double>& noise, const std::vector<log::Record>& records) {
  constexpr double kScatter = 1.5;
  std::vector<double> forces;
  for (std::size_t r = 0; r < noise.size(); ++r) {
    forces.push_back(noise[r] * records[r].force_deviation);
  }
  return {kScatter * measurement::medianOf(forces), kScatter * measurement::medianOf(noise)};
}

}  // namespace rubber_suspension::diagnosis
