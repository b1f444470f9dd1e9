// The rules for time of a stream of samples.
#include "rubber_suspension/component/sample_stream.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension {
namespace {

constexpr double kLongestGap = 9e9;  // [s], what fits into signed nanoseconds

// later - earlier [ns]; both may lie anywhere, so the difference may be more than a signed number holds.
std::uint64_t between(std::int64_t earlier, std::int64_t later) {
  return static_cast<std::uint64_t>(later) - static_cast<std::uint64_t>(earlier);
}

}  // namespace

SampleStream::SampleStream(const Component& component, double max_gap)
    : component_(component),
      max_gap_(static_cast<std::uint64_t>(std::llround(std::clamp(max_gap, 0.0, kLongestGap) * kNanosecondsPerSecond))),
      state_(component.makeState()),
      before_(state_) {}

Verdict SampleStream::judge(std::int64_t stamp, double displacement) const {
  if (!std::isfinite(displacement)) {
    return Verdict::not_finite;
  }
  if (!started_) {
    return Verdict::accepted;
  }
  if (stamp == last_stamp_) {
    return Verdict::repeated;
  }
  if (stamp < last_stamp_) {
    return between(stamp, last_stamp_) > kRestartJump ? Verdict::restarted : Verdict::stepped_back;
  }
  return between(last_stamp_, stamp) > max_gap_ ? Verdict::bridged : Verdict::accepted;
}

void SampleStream::count(Verdict verdict) {
  counters_.accepted += isAccepted(verdict) ? 1 : 0;
  switch (verdict) {
    case Verdict::accepted:
      break;
    case Verdict::restarted:
      ++counters_.restarted;
      break;
    case Verdict::bridged:
      ++counters_.bridged;
      break;
    case Verdict::not_finite:
      ++counters_.not_finite;
      break;
    case Verdict::repeated:
      ++counters_.repeated;
      break;
    case Verdict::stepped_back:
      ++counters_.stepped_back;
      break;
  }
}

ComponentForce SampleStream::advance(Verdict verdict, std::int64_t stamp, double displacement) {
  if (!started_ || verdict == Verdict::restarted) {
    return component_.rest(state_, displacement);
  }
  const double dt = static_cast<double>(between(last_stamp_, stamp)) / static_cast<double>(kNanosecondsPerSecond);
  return component_.step(state_, dt, displacement);
}

StreamForce SampleStream::push(std::int64_t stamp, double displacement) {
  StreamForce result{judge(stamp, displacement), {}};
  if (isAccepted(result.verdict)) {
    before_.recall(state_);
    const ComponentForce force = advance(result.verdict, stamp, displacement);
    if (std::isfinite(force.total)) {
      result.force = force;
      last_stamp_ = stamp;
      started_ = true;
    } else {
      // A displacement can be finite and yet too large for a law that stiffens; the state must not keep that.
      state_.recall(before_);
      result.verdict = Verdict::not_finite;
    }
  }
  count(result.verdict);
  return result;
}

void SampleStream::reset() {
  component_.rest(state_, 0.0);
  started_ = false;
}

void SampleStream::restore(std::int64_t last_stamp, double displacement, const std::vector<double>& memory) {
  state_.restore(displacement, memory);
  last_stamp_ = last_stamp;
  started_ = true;
}

}  // namespace rubber_suspension
