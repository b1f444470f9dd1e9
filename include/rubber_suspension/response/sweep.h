// Stiffness and loss angle at many points. All functions except logSpaced() throw as simulateSettledLoop() does.
#pragma once

#include <vector>

#include "rubber_suspension/response/settled_loop.h"

namespace rubber_suspension::response {

struct SweepPoint {
  double frequency = 0.0;  ///< [Hz]
  double amplitude = 0.0;  ///< [m]
  Characteristics characteristics;
  bool settled = true;  ///< false if the simulated loop did not repeat within the maximum number of cycles
};

/// Returns the characteristics at a frequency [Hz] and an amplitude [m]. Those of a linear component have a closed
/// form; for others a loop is simulated until it settles.
SweepPoint characteristicsAt(const component::Component& component, double frequency, double amplitude,
                             const LoopOptions& options = {});

std::vector<SweepPoint> sweepFrequency(const component::Component& component, const std::vector<double>& frequencies,
                                       double amplitude, const LoopOptions& options = {});

std::vector<SweepPoint> sweepAmplitude(const component::Component& component, const std::vector<double>& amplitudes,
                                       double frequency, const LoopOptions& options = {});

/// The amplitudes are A = P/f with a given product P [m Hz], as is roughly true of track excitation (Polach Eq. 3).
std::vector<SweepPoint> sweepConstantProduct(const component::Component& component,
                                             const std::vector<double>& frequencies, double product,
                                             const LoopOptions& options = {});

/// Returns `count` numbers, evenly spaced on a logarithmic axis, from exactly `low` to exactly `high`.
std::vector<double> logSpaced(double low, double high, int count);

}  // namespace rubber_suspension::response
