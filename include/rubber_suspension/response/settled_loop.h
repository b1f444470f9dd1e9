// Simulates a component under a sine until each cycle repeats the one before.
#pragma once

#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/response/characteristics.h"

namespace rubber_suspension::response {

struct LoopOptions {
  /// Number of samples per cycle, a multiple of 4, so that turning points and zero crossings are samples.
  int samples = 720;
  /// The loop counts as settled if the remaining change of the force, divided by the range of the force, is at most
  /// this. The changes of the last two cycles are extrapolated to all later ones as a geometric series.
  double tolerance = 1e-9;
  int maximum_cycles = 20000;
  /// Mean of the sine [m], which represents the preload of a nonlinear component.
  double mean = 0.0;
};

/// One cycle of the displacement z = mean - A cos(phase), which begins at the lower turning point.
struct SettledLoop {
  double frequency = 0.0;            ///< [Hz]
  double amplitude = 0.0;            ///< [m]
  std::vector<double> displacement;  ///< [m]
  std::vector<double> force;         ///< [N]; linear laws contribute no force at the mean displacement
  int cycles = 0;                    ///< number of simulated cycles; 0 if all laws have a closed form
  double remaining = 0.0;            ///< remaining change of the force, divided by its range [-]
  bool settled = false;              ///< true if `remaining` is at most the tolerance

  /// Returns the characteristics by Eqs. 1 and 2 of Polach. Peaks are interpolated. The area follows from the
  /// trapezoidal rule in phase, whose error for smooth branches falls with the fourth power of the step.
  Characteristics characteristics() const;
};

/// Simulates a component under a sine of this frequency [Hz] and amplitude [m] until it settles.
///
/// If all elements act in parallel, linear ones contribute the exact force that follows from K*. The nonlinear ones are
/// simulated; Berg friction starts on its settled loop. If there are effects in series (compliance, free play, delay,
/// softening, heating), the whole component is simulated with a displacement that is linear between samples, so that
/// the force of a dashpot lags by half a sample. A loop that does not settle within maximum_cycles has settled = false;
/// self-heating may take minutes. Throws std::invalid_argument for a frequency, an amplitude or options out of range.
SettledLoop simulateSettledLoop(const component::Component& component, double frequency, double amplitude,
                                const LoopOptions& options = {});

}  // namespace rubber_suspension::response
