// Acceptance of stamped samples.
#include "rubber_suspension/component/sample_stream.h"

#include <algorithm>
#include <cmath>

#include "component/equal_run.h"
#include "kernel/sample_checks.h"

namespace rubber_suspension::component {
namespace {

constexpr double kLongestGap = 9e9;  // [s]; fits into signed nanoseconds

}  // namespace

double StampedStream::secondsBetween(std::int64_t earlier, std::int64_t later) {
  return static_cast<double>(between(earlier, later)) / static_cast<double>(kNanosecondsPerSecond);
}

StampedStream::StampedStream(double max_gap)
    : max_gap_(
          static_cast<std::uint64_t>(std::llround(std::clamp(max_gap, 0.0, kLongestGap) * kNanosecondsPerSecond))) {}

SampleStream::SampleStream(const Component& component, double max_gap)
    : StampedStream(max_gap), component_(component), state_(component.makeState()), saved_(state_) {}

Acceptance StampedStream::judge(std::int64_t stamp, bool finite) const {
  if (!finite) {
    return Acceptance::not_finite;
  }
  if (!started_) {
    return Acceptance::accepted;
  }
  if (stamp == last_stamp_) {
    return Acceptance::repeated;
  }
  if (stamp < last_stamp_) {
    return between(stamp, last_stamp_) > kRestartJump ? Acceptance::restarted : Acceptance::stepped_back;
  }
  return between(last_stamp_, stamp) > max_gap_ ? Acceptance::bridged : Acceptance::accepted;
}

void StampedStream::count(Acceptance acceptance) {
  counters_.accepted += isAccepted(acceptance) ? 1 : 0;
  if (acceptance == Acceptance::accepted) {
    return;  // the usual case; another order of branches would be slower
  }
  switch (acceptance) {
    case Acceptance::accepted:
      break;
    case Acceptance::restarted:
      ++counters_.restarted;
      break;
    case Acceptance::bridged:
      ++counters_.bridged;
      break;
    case Acceptance::not_finite:
      ++counters_.not_finite;
      break;
    case Acceptance::repeated:
      ++counters_.repeated;
      break;
    case Acceptance::stepped_back:
      ++counters_.stepped_back;
      break;
    case Acceptance::force_not_finite:
      ++counters_.force_not_finite;
      break;
    case Acceptance::not_a_rotation:
      ++counters_.not_a_rotation;
      break;
    case Acceptance::beyond_measure:
      ++counters_.beyond_measure;
      break;
  }
}

void SampleStream::save() {
  saved_.copyFrom(state_);
  step_count_ = 0;
}

// Undoes the last step. Restores the saved state if there was no step after it.
void SampleStream::rollBack() {
  step_count_ -= step_count_ > 0 ? 1 : 0;
  state_.copyFrom(saved_);
  for (std::size_t i = 0; i < step_count_; ++i) {
    component_.step(state_, steps_[i].dt, steps_[i].displacement);
  }
}

element::ComponentForce SampleStream::initialise(double displacement) {
  save();
  const element::ComponentForce force = component_.initialise(state_, displacement);
  if (std::isfinite(force.total) && state_.isFinite()) {
    save();
  }
  return force;
}

element::ComponentForce SampleStream::advance(Acceptance acceptance, std::int64_t stamp, double displacement) {
  if (!started_ || acceptance == Acceptance::restarted) {
    return initialise(displacement);
  }
  if (step_count_ == kMostSteps) {
    save();
  }
  const double dt = secondsBetween(last_stamp_, stamp);
  if (acceptance == Acceptance::accepted) {
    usual_ = {between(last_stamp_, stamp), dt};
  }
  steps_[step_count_++] = {dt, displacement};
  return component_.step(state_, dt, displacement);
}

// A finite displacement may be too large for a stiffening law, and must then not remain in the state. A delay or a
// filter must not store such a displacement either, because a later force would overflow.
StreamForce SampleStream::pushAny(std::int64_t stamp, double displacement) {
  StreamForce result{judge(stamp, std::isfinite(displacement)), {}};
  if (isAccepted(result.acceptance)) {
    if (std::abs(displacement) > kLargest) {
      count(Acceptance::force_not_finite);
      return {Acceptance::force_not_finite, {}};
    }
    result.force = advance(result.acceptance, stamp, displacement);
    if (!std::isfinite(result.force.total)) {
      return refuseForce();
    }
    last_stamp_ = stamp;
    started_ = true;
  }
  count(result.acceptance);
  return result;
}

StreamForce SampleStream::refuseForce() {
  rollBack();
  count(Acceptance::force_not_finite);
  return {Acceptance::force_not_finite, {}};
}

// Returns the number of following samples that have equal time steps and are accepted by their stamps.
std::size_t SampleStream::evenRun(const std::int64_t* stamp, const double* displacement, std::size_t count) const {
  constexpr std::size_t kMost = 4096;  // samples that may have to be pushed again if a force of the run is not finite
  constexpr std::size_t kTogether = 128;  // steps that are checked together
  if (!started_ || judge(stamp[0], std::isfinite(displacement[0])) != Acceptance::accepted) {
    return 0;
  }
  const std::uint64_t step = between(last_stamp_, stamp[0]);
  std::size_t size = 1;
  const std::size_t most = std::min(kMost, count);
  while (size + kTogether <= most && kernel::allEven(stamp + size - 1, kTogether, step)) {
    size += kTogether;
  }
  while (size < most && between(stamp[size - 1], stamp[size]) == step && stamp[size] > stamp[size - 1]) {
    ++size;
  }
  return size;
}

// Returns false, without effect, if a displacement is too large or a force is not finite.
bool SampleStream::pushRun(const std::int64_t* stamp, const double* displacement, std::size_t count, double* force) {
  constexpr unsigned kPower = 99;  // 2^99 is 0.63 of the largest displacement; larger ones are pushed one by one
  if (!kernel::allBelowTwoTo(kPower, displacement, count)) {
    return false;
  }
  save();
  component_.simulate(state_, secondsBetween(last_stamp_, stamp[0]), displacement, count, force);
  if (!kernel::allFinite(force, count) || !state_.isFinite()) {
    rollBack();
    return false;
  }
  save();
  last_stamp_ = stamp[count - 1];
  counters_.accepted += count;
  return true;
}

std::size_t SampleStream::pushAll(const std::int64_t* stamp, const double* displacement, std::size_t count,
                                  double* force) {
  for (std::size_t i = 0; i < count;) {
    const std::size_t run = evenRun(stamp + i, displacement + i, count - i);
    if (run > 1 && pushRun(stamp + i, displacement + i, run, force + i)) {
      i += run;
      continue;
    }
    for (const std::size_t end = i + std::max<std::size_t>(run, 1); i < end; ++i) {
      const StreamForce result = push(stamp[i], displacement[i]);
      if (!isAccepted(result.acceptance)) {
        return i;
      }
      force[i] = result.force.total;
    }
  }
  return count;
}

bool SampleStream::setTemperature(double temperature) {
  if (!component_.shiftsWithTemperature()) {
    return true;
  }
  if (!component_.temperatures().contains(temperature)) {
    return false;
  }
  component_.setTemperature(state_, temperature);
  save();  // only steps after the change of temperature can be repeated
  return true;
}

std::size_t SampleStream::pushAll(const std::int64_t* stamp, const double* displacement, const double* temperature,
                                  std::size_t count, double* force) {
  if (temperature == nullptr || !component_.shiftsWithTemperature()) {
    return pushAll(stamp, displacement, count, force);
  }
  for (std::size_t first = 0; first < count;) {
    const std::size_t size = equalRun(temperature + first, count - first);
    if (!setTemperature(temperature[first])) {
      return first;
    }
    const std::size_t accepted = pushAll(stamp + first, displacement + first, size, force + first);
    first += accepted;
    if (accepted < size) {
      return first;
    }
  }
  return count;
}

void SampleStream::reset() {
  component_.initialise(state_, 0.0);
  save();
  started_ = false;
  usual_ = {};
}

void SampleStream::deserialise(std::int64_t last_stamp, double displacement, const std::vector<double>& memory) {
  component_.restore(state_, displacement, memory);
  save();
  last_stamp_ = last_stamp;
  started_ = true;
}

}  // namespace rubber_suspension::component
