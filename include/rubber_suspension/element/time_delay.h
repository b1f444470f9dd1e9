// Time delay between the measured displacement and force. Throws nothing: makeElement() checks the values.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// The test piece sees z(t - T): the force is late by T > 0, so the loss angle falls by 360 degrees times f T (1 ms
/// is 3.6 degrees at 10 Hz), down to negative values; the magnitude stays. T < 0 raises it, as a late displacement
/// signal does.
///
/// T > 0: past samples stand in a ring in the memory, linear in between, at any step length; before the start the
/// displacement was constant. The ring holds 256 samples. Where the sampling is finer than T/126 the samples are
/// thinned to that distance, so the ring is never too short; the error is then that of a chord, (w T/126)^2/8 under a
/// sine.
///
/// T < 0: the displacement is carried forward along the last step, z + |T| dz/dt, good while w |T| is well below 1
/// (error (w T)^2/2) and noise is small: |T| should be a few samples at most.
///
/// Source: shift theorem of the Fourier transform, K* exp(-i w T).
class TimeDelay final : public DisplacementEffect {
 public:
  static constexpr double kLongestAdvance = 0.02;  ///< [s]
  static constexpr double kLongestDelay = 0.05;    ///< [s]

  explicit TimeDelay(double delay /* T [s] */) : delay_(delay) {}

  std::size_t memorySize() const override;
  bool acceptsMemory(const double* memory) const override;
  double initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;

  /// The record of a displacement or force is late.
  bool ofSensor() const override { return true; }
  bool ofMeasuringChain() const override { return true; }

  /// exp(-i w T) for T > 0, 1 + i w |T| for T < 0, which is what the extrapolation does.
  std::optional<std::complex<double>> transfer(double omega) const override;
  bool passive() const override { return false; }

 private:
  void store(double time, double displacement, double* memory) const;
  double lookUp(double time, const double* memory) const;

  double delay_;
};

ElementType timeDelayType();

}  // namespace rubber_suspension::element
