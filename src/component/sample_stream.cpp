// The rules for time of a stream of samples.
#include "rubber_suspension/component/sample_stream.h"

#include <cmath>

namespace rubber_suspension {

SampleStream::SampleStream(const Component& component, double max_gap)
    : component_(component),
      max_gap_(static_cast<std::int64_t>(std::llround(max_gap * kNanosecondsPerSecond))),
      state_(component.makeState()) {}

Verdict SampleStream::judge(std::int64_t stamp, double displacement) const {
  if (!std::isfinite(displacement)) {
    return Verdict::not_finite;
  }
  if (!started_) {
    return Verdict::accepted;
  }
  const std::int64_t elapsed = stamp - last_stamp_;
  if (elapsed == 0) {
    return Verdict::repeated;
  }
  if (elapsed < 0) {
    return elapsed < -kRestartJump ? Verdict::restarted : Verdict::stepped_back;
  }
  return elapsed > max_gap_ ? Verdict::bridged : Verdict::accepted;
}

void SampleStream::count(Verdict verdict) {
  counters_.accepted += isAccepted(verdict) ? 1 : 0;
  counters_.restarted += verdict == Verdict::restarted ? 1 : 0;
  counters_.bridged += verdict == Verdict::bridged ? 1 : 0;
  counters_.not_finite += verdict == Verdict::not_finite ? 1 : 0;
  counters_.repeated += verdict == Verdict::repeated ? 1 : 0;
  counters_.stepped_back += verdict == Verdict::stepped_back ? 1 : 0;
}

StreamForce SampleStream::push(std::int64_t stamp, double displacement) {
  StreamForce result{judge(stamp, displacement), {}};
  count(result.verdict);
  if (!isAccepted(result.verdict)) {
    return result;
  }
  if (!started_ || result.verdict == Verdict::restarted) {
    result.force = component_.rest(state_, displacement);
    started_ = true;
  } else {
    const double dt = static_cast<double>(stamp - last_stamp_) / static_cast<double>(kNanosecondsPerSecond);
    result.force = component_.step(state_, dt, displacement);
  }
  last_stamp_ = stamp;
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
