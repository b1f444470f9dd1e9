// The loop that a component settles on under a sine: simulated until one cycle repeats the one before.
#pragma once

#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/response/characteristics.h"

namespace rubber_suspension::response {

struct LoopOptions {
  /// Samples per cycle, a multiple of 4 so that turning points and zero crossings are samples.
  int samples = 720;
  /// The loop counts as settled once the change of the force that is still to come, extrapolated from the last two
  /// cycles as a geometric series, is below this part of the range of the force.
  double tolerance = 1e-9;
  int maximum_cycles = 20000;
  /// Mean of the sine [m], for the preload of a nonlinear component.
  double mean = 0.0;
};

/// One cycle z = mean - A cos(phase), from the lower turning point.
struct SettledLoop {
  double frequency = 0.0;            ///< [Hz]
  double amplitude = 0.0;            ///< [m]
  std::vector<double> displacement;  ///< [m]
  std::vector<double> force;         ///< [N]; of linear laws without the force of the mean displacement
  int cycles = 0;                    ///< simulated cycles; 0 if all laws are in closed form
  double remaining = 0.0;            ///< change of the force still to come, over its range [-]
  bool settled = false;              ///< remaining is below the tolerance

  /// Returns the characteristics by Eqs. 1 and 2, with interpolated peaks and the area by the trapezoidal rule in
  /// phase, which for smooth branches converges with the fourth power of the step. A loss below rounding is 0.
  Characteristics characteristics() const;
};

/// Simulates a component under a sine of this frequency [Hz] and amplitude [m] until it settles.
///
/// If all elements act in parallel, linear ones are evaluated by K* without discretisation, and the others are
/// simulated until they repeat; Berg friction starts on its settled loop. With effects in series (compliance, free
/// play, delay, softening, heating) the whole component is simulated with displacement linear between samples, so that
/// a dashpot lags by half a sample. A loop that does not settle within maximum_cycles (self-heating may take minutes)
/// has settled = false. Throws std::invalid_argument for a frequency, an amplitude or options out of range.
SettledLoop simulateSettledLoop(const component::Component& component, double frequency, double amplitude,
                                const LoopOptions& options = {});

}  // namespace rubber_suspension::response
