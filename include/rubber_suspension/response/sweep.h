// Stiffness and loss angle over frequency and amplitude. All but logSpaced() throw as simulateSettledLoop() does.
#pragma once

#include <vector>

#include "rubber_suspension/response/settled_loop.h"

namespace rubber_suspension::response {

struct SweepPoint {
  double frequency = 0.0;  ///< [Hz]
  double amplitude = 0.0;  ///< [m]
  Characteristics characteristics;
  bool settled = true;  ///< false if the simulated loop did not repeat within the cycles allowed
};

/// Returns the characteristics at a frequency [Hz] and an amplitude [m]: in closed form for a linear component, else of
/// a settled simulated loop.
SweepPoint characteristicsAt(const component::Component& component, double frequency, double amplitude,
                             const LoopOptions& options = {});

std::vector<SweepPoint> sweepFrequency(const component::Component& component, const std::vector<double>& frequencies,
                                       double amplitude, const LoopOptions& options = {});

std::vector<SweepPoint> sweepAmplitude(const component::Component& component, const std::vector<double>& amplitudes,
                                       double frequency, const LoopOptions& options = {});

/// The amplitudes are A = P/f with the product P [m Hz], roughly as those of a track excitation (Polach Eq. 3).
std::vector<SweepPoint> sweepConstantProduct(const component::Component& component,
                                             const std::vector<double>& frequencies, double product,
                                             const LoopOptions& options = {});

/// Returns `count` numbers from `low` to `high`, evenly spaced on a log axis, both ends exact.
std::vector<double> logSpaced(double low, double high, int count);

}  // namespace rubber_suspension::response
