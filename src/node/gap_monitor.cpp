// Matches measured to simulated forces by stamp.
#include "node/gap_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubber_suspension::node {

void GapMonitor::forget() {
  first_ = count_;
  counters_.unmatched += waiting_.size();
  waiting_.clear();
}

void GapMonitor::match(MatchedSample& sample, double force) {
  if (std::isnan(sample.measured)) {
    sample.measured = force;
    ++counters_.matched;
  } else {
    ++counters_.unmatched;  // a second force of one stamp
  }
}

// Measured forces that came before their sample. Those older than it will find none any more.
void GapMonitor::takeWaiting(MatchedSample& sample) {
  const auto is_past = [&](const Waiting& waiting) {
    if (waiting.stamp == sample.stamp) {
      match(sample, waiting.force);
    } else if (waiting.stamp < sample.stamp) {
      ++counters_.unmatched;
    }
    return waiting.stamp <= sample.stamp;
  };
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_past), waiting_.end());
}

void GapMonitor::addSimulated(std::int64_t stamp, double displacement, double force) {
  if (!wanted_.load(std::memory_order_relaxed)) {
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (count_ > first_ && stamp <= at(count_ - 1).stamp) {
    first_ = count_;  // what waits may belong to the new replay
  }
  MatchedSample& sample = at(count_++);
  sample = {stamp, displacement, force, std::numeric_limits<double>::quiet_NaN()};
  if (!waiting_.empty()) {
    takeWaiting(sample);
  }
}

MatchedSample* GapMonitor::find(std::int64_t stamp) {
  // Bisection over the numbers of the samples, whose stamps increase.
  std::uint64_t low = oldest();
  std::uint64_t high = count_;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (at(middle).stamp < stamp) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < count_ && at(low).stamp == stamp ? &at(low) : nullptr;
}

bool GapMonitor::addMeasured(std::int64_t stamp, double force) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!wanted_) {
    samples_.resize(kCapacity);
    waiting_.reserve(kWaiting);
    wanted_ = true;
  }
  if (!std::isfinite(force)) {
    ++counters_.not_finite;
    return false;
  }
  if (MatchedSample* sample = find(stamp)) {
    match(*sample, force);
  } else if (waiting_.size() < kWaiting && (count_ == first_ || stamp > at(count_ - 1).stamp)) {
    waiting_.push_back({stamp, force});
  } else {
    ++counters_.unmatched;
  }
  return true;
}

void GapMonitor::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  forget();
}

std::vector<MatchedSample> GapMonitor::window(double window) const {
  constexpr std::uint64_t kPiece = 512;
  std::vector<MatchedSample> samples;
  std::uint64_t next = 0;
  std::int64_t begin = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!wanted_ || count_ == first_) {
      return samples;
    }
    next = oldest();
    begin = at(count_ - 1).stamp - static_cast<std::int64_t>(std::llround(window * 1e9));
  }
  samples.reserve(kCapacity);
  for (bool more = true; more;) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (next < oldest()) {
      next = oldest();
      samples.clear();  // overtaken, or a new replay
    }
    const std::uint64_t end = std::min(next + kPiece, count_);
    for (; next < end; ++next) {
      const MatchedSample& sample = at(next);
      if (sample.stamp >= begin && !std::isnan(sample.measured)) {
        samples.push_back(sample);
      }
    }
    more = next < count_;
  }
  return samples;
}

MatchCounters GapMonitor::counters() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return counters_;
}

}  // namespace rubber_suspension::node
