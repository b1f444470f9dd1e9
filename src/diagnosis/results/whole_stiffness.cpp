// The whole component at its nominal point.
#include "diagnosis/results/whole_stiffness.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "numerics/median.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::diagnosis::results {
namespace {

double amplitudeOf(const log::Record& record) {
  const Eigen::ArrayXd z = record.displacement.array() - record.displacement.mean();
  return std::sqrt(2.0 * z.square().mean());
}

double medianAmplitude(const std::vector<log::Record>& logs, double frequency) {
  std::vector<double> near;
  std::vector<double> all;
  for (const log::Record& record : logs) {
    all.push_back(amplitudeOf(record));
    if (std::abs(std::log2(record.mean_frequency / frequency)) <= 1.0) {
      near.push_back(all.back());
    }
  }
  return numerics::medianOf(near.empty() ? all : near);
}

// As a test machine measures it: heat and drift go on for minutes after these cycles.
std::optional<response::Characteristics> measuredAt(const io::ComponentDescription& component, double frequency,
                                                    double amplitude) {
  response::LoopOptions options;
  options.maximum_cycles = 20;
  try {
    const auto point =
        response::characteristicsAt(component.withoutRig().makeComponent(), frequency, amplitude, options);
    return std::isfinite(point.characteristics.stiffness) ? std::optional(point.characteristics) : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<WholeStiffness> wholeStiffness(const io::ComponentDescription& before,
                                             const io::ComponentDescription& after,
                                             const std::vector<log::Record>& logs) {
  std::vector<double> frequencies(logs.size());
  std::transform(logs.begin(), logs.end(), frequencies.begin(),
                 [](const log::Record& record) { return record.mean_frequency; });
  const auto& specification = before.specification();
  WholeStiffness whole;
  whole.frequency =
      specification.has("nominal_frequency") ? specification.at("nominal_frequency") : numerics::medianOf(frequencies);
  whole.nominal_amplitude = specification.has("nominal_amplitude");
  whole.amplitude =
      whole.nominal_amplitude ? specification.at("nominal_amplitude") : medianAmplitude(logs, whole.frequency);
  const auto was = measuredAt(before, whole.frequency, whole.amplitude);
  const auto is = measuredAt(after, whole.frequency, whole.amplitude);
  if (!was || !is) {
    return std::nullopt;
  }
  whole.stiffness = {was->stiffness, is->stiffness};
  whole.loss_angle = {was->loss_angle, is->loss_angle};
  return whole;
}

}  // namespace rubber_suspension::diagnosis::results
