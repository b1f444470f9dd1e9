// Time delay between the measured displacement and force.
#include "rubber_suspension/element/time_delay.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::element {
namespace {

constexpr int kSamples = 256;
// Whole spacings that the ring is sure to hold: of two intervals in a row at least one spacing is kept (see store()).
constexpr int kSpacings = kSamples / 2 - 2;

// Memory: the time since the start, the index of the newest sample, how many there are, then times and displacements.
enum DelaySlot { kTime, kNewest, kCount, kTimes, kDisplacements = kTimes + kSamples, kEnd = kDisplacements + kSamples };

int before(int index) { return (index + kSamples - 1) % kSamples; }
int after(int index) { return (index + 1) % kSamples; }

bool isWhole(double value, int low, int high) { return value >= low && value <= high && std::floor(value) == value; }

}  // namespace

std::size_t TimeDelay::memorySize() const { return delay_ > 0.0 ? kEnd : 0; }

bool TimeDelay::acceptsMemory(const double* memory) const {
  return delay_ <= 0.0 || (isWhole(memory[kNewest], 0, kSamples - 1) && isWhole(memory[kCount], 1, kSamples));
}

double TimeDelay::initialise(double displacement, double* memory) const {
  if (delay_ > 0.0) {
    std::fill(memory, memory + kEnd, 0.0);
    memory[kCount] = 1.0;
    memory[kDisplacements] = displacement;
  }
  return displacement;
}

double TimeDelay::step(const Motion& motion, double* memory) const {
  if (delay_ <= 0.0) {
    return motion.displacement - delay_ * (motion.increment / motion.dt);
  }
  memory[kTime] += motion.dt;
  store(memory[kTime], motion.displacement, memory);
  return lookUp(memory[kTime] - delay_, memory);
}

// The newest sample is provisional: the next one takes its place if both lie within one spacing of the sample before.
void TimeDelay::store(double time, double displacement, double* memory) const {
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

double TimeDelay::lookUp(double time, const double* memory) const {
  int later = static_cast<int>(memory[kNewest]);
  int earlier = later;
  for (int left = static_cast<int>(memory[kCount]) - 1; left > 0 && memory[kTimes + earlier] > time; --left) {
    later = earlier;
    earlier = before(earlier);
  }
  const double start = memory[kTimes + earlier];
  if (time <= start || earlier == later) {
    return memory[kDisplacements + earlier];  // before the start: at rest
  }
  const double share = (time - start) / (memory[kTimes + later] - start);
  return memory[kDisplacements + earlier] + share * (memory[kDisplacements + later] - memory[kDisplacements + earlier]);
}

std::optional<std::complex<double>> TimeDelay::transfer(double omega) const {
  return delay_ > 0.0 ? std::polar(1.0, -omega * delay_) : std::complex<double>(1.0, -omega * delay_);
}

ElementType timeDelayType() {
  return {"time_delay",
          "Force late against the displacement (delay > 0) or early (delay < 0).",
          {{"delay", "s", Role::shape, Range::closed(-TimeDelay::kLongestAdvance, TimeDelay::kLongestDelay),
            "delay T of the force; a negative one should be a few samples at most"}},
          makes<TimeDelay>("delay")};
}

}  // namespace rubber_suspension::element
