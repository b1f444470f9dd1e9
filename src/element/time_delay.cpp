// Time delay between the measured displacement and force.
#include <algorithm>
#include <cmath>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

constexpr double kLongestAdvance = 0.02;  // [s]
constexpr double kLongestDelay = 0.05;    // [s]
constexpr int kSamples = 256;
// The ring covers at least this number of spacings, since two consecutive intervals exceed one spacing (see store()).
constexpr int kSpacings = kSamples / 2 - 2;

// Memory: the time since the start, the index of the newest sample, the number of samples, times and displacements.
enum DelaySlot { kTime, kNewest, kCount, kTimes, kDisplacements = kTimes + kSamples, kEnd = kDisplacements + kSamples };

int before(int index) { return (index + kSamples - 1) % kSamples; }
int after(int index) { return (index + 1) % kSamples; }

bool isWhole(double value, int low, int high) { return value >= low && value <= high && std::floor(value) == value; }

/// Delays the displacement of the test piece to z(t - T). For T > 0 the force is late, so the loss angle falls by 360
/// degrees times f T (3.6 degrees for 1 ms at 10 Hz), possibly below zero, while the magnitude does not change. T < 0
/// increases the loss angle, as a late displacement signal does.
///
/// For T > 0 a ring buffer in the memory contains 256 past samples at any step length. The displacement is linear
/// between them and constant before the start. If the sampling interval is below T/126, the samples are thinned to
/// intervals of about T/126, so that the ring always covers T. Linear interpolation then errs by (w T/126)^2/8 of the
/// amplitude under a sine.
///
/// For T < 0 the displacement is extrapolated along the last step, z + |T| dz/dt, which is valid while w |T| is well
/// below 1 (error (w T)^2/2) and noise is small. |T| should be a few samples at most.
///
/// Source: shift theorem of the Fourier transform, K* exp(-i w T).
class TimeDelay final : public DisplacementEffect {
 public:
  explicit TimeDelay(double delay /* T [s] */) : delay_(delay) {}

  std::size_t memorySize() const override { return delay_ > 0.0 ? kEnd : 0; }
  bool acceptsMemory(const double* memory) const override {
    return delay_ <= 0.0 || (isWhole(memory[kNewest], 0, kSamples - 1) && isWhole(memory[kCount], 1, kSamples));
  }

  double initialise(double displacement, double* memory) const override {
    if (delay_ > 0.0) {
      std::fill(memory, memory + kEnd, 0.0);
      memory[kCount] = 1.0;
      memory[kDisplacements] = displacement;
    }
    return displacement;
  }

  double step(const Motion& motion, double* memory) const override {
    if (delay_ <= 0.0) {
      return motion.displacement - delay_ * (motion.increment / motion.dt);
    }
    memory[kTime] += motion.dt;
    store(memory[kTime], motion.displacement, memory);
    return lookUp(memory[kTime] - delay_, memory);
  }

  bool ofSensor() const override { return true; }
  bool ofMeasuringChain() const override { return true; }

  /// Returns exp(-i w T) for T > 0, or 1 + i w |T| for T < 0, which is the transfer function of the extrapolation.
  std::optional<std::complex<double>> transfer(double omega) const override {
    return delay_ > 0.0 ? std::polar(1.0, -omega * delay_) : std::complex<double>(1.0, -omega * delay_);
  }
  bool passive() const override { return false; }

 private:
  // Stores a sample, which replaces the newest one if it is within one spacing of the sample before the newest.
  void store(double time, double displacement, double* memory) const {
    int newest = static_cast<int>(memory[kNewest]);
    const bool replace = memory[kCount] >= 2.0 && time - memory[kTimes + before(newest)] < delay_ / kSpacings;
    if (!replace) {
      newest = after(newest);
      memory[kNewest] = newest;
      memory[kCount] = std::min(memory[kCount] + 1.0, static_cast<double>(kSamples));
    }
    memory[kTimes + newest] = time;
    memory[kDisplacements + newest] = displacement;
  }

  double lookUp(double time, const double* memory) const {
    int later = static_cast<int>(memory[kNewest]);
    int earlier = later;
    for (int left = static_cast<int>(memory[kCount]) - 1; left > 0 && memory[kTimes + earlier] > time; --left) {
      later = earlier;
      earlier = before(earlier);
    }
    const double start = memory[kTimes + earlier];
    if (time <= start || earlier == later) {
      return memory[kDisplacements + earlier];  // at rest before the start
    }
    const double share = (time - start) / (memory[kTimes + later] - start);
    return memory[kDisplacements + earlier] +
           share * (memory[kDisplacements + later] - memory[kDisplacements + earlier]);
  }

  double delay_;
};

const ElementEntry kTimeDelayEntry(420,
                                   {"time_delay",
                                    "Force recorded later than the displacement (delay > 0) or earlier (delay < 0).",
                                    {{"delay", "s", Role::shape, Range::closed(-kLongestAdvance, kLongestDelay),
                                      "delay T of the force; if negative, a few samples at most"}},
                                    makes<TimeDelay>("delay")});

}  // namespace
}  // namespace rubber_suspension::element
