// Computes stiffness and loss angle at many frequencies and amplitudes.
#include "rubber_suspension/response/sweep.h"

#include <cmath>

namespace rubber_suspension::response {

SweepPoint characteristicsAt(const component::Component& component, double frequency, double amplitude,
                             const LoopOptions& options) {
  if (const auto stiffness = component.complexStiffness(frequency)) {
    return {frequency, amplitude, characteristicsOfEllipse(*stiffness, amplitude), true};
  }
  const SettledLoop loop = simulateSettledLoop(component, frequency, amplitude, options);
  return {frequency, amplitude, loop.characteristics(), loop.settled};
}

std::vector<SweepPoint> sweepFrequency(const component::Component& component, const std::vector<double>& frequencies,
                                       double amplitude, const LoopOptions& options) {
  std::vector<SweepPoint> points;
  for (const double frequency : frequencies) {
    points.push_back(characteristicsAt(component, frequency, amplitude, options));
  }
  return points;
}

std::vector<SweepPoint> sweepAmplitude(const component::Component& component, const std::vector<double>& amplitudes,
                                       double frequency, const LoopOptions& options) {
  std::vector<SweepPoint> points;
  for (const double amplitude : amplitudes) {
    points.push_back(characteristicsAt(component, frequency, amplitude, options));
  }
  return points;
}

std::vector<SweepPoint> sweepConstantProduct(const component::Component& component,
                                             const std::vector<double>& frequencies, double product,
                                             const LoopOptions& options) {
  std::vector<SweepPoint> points;
  for (const double frequency : frequencies) {
    points.push_back(characteristicsAt(component, frequency, product / frequency, options));
  }
  return points;
}

std::vector<double> logSpaced(double low, double high, int count) {
  std::vector<double> values(count, low);
  for (int i = 1; i < count; ++i) {
    values[i] = i + 1 == count ? high : low * std::pow(high / low, static_cast<double>(i) / (count - 1));
  }
  return values;
}

}  // namespace rubber_suspension::response
