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

/// Returns the characteristics at one frequency [Hz] and amplitude [m]: in closed form for a linear component, from a
/// settled simulated loop for others.
SweepPoint characteristicsAt(const component::Component& component, double frequency, double amplitude,
                             const LoopOptions& options = {});

std::vector<SweepPoint> sweepFrequency(const component::Component& component, const std::vector<double>& frequencies,
                                       double amplitude, const LoopOptions& options = {});

std::vector<SweepPoint> sweepAmplitude(const component::Component& component, const std::vector<double>& amplitudes,
                                       double frequency, const LoopOptions& options = {});

/// Returns the characteristics at A = P/f with the product P [m Hz]; the amplitude of a track excitation falls about so
/// (Polach Eq. 3).
std::vector<SweepPoint> sweepConstantProduct(const component::Component& component,
                                             const std::vector<double>& frequencies, double product,
                                             const LoopOptions& options = {});

/// Returns `count` numbers from `low` to `high`, evenly spaced on a log axis, both ends exact.
std::vector<double> logSpaced(double low, double high, int count);

}  // namespace rubber_suspension::response
