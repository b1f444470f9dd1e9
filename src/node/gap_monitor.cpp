// Matches measured to simulated forces by stamp.
#include "node/gap_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubber_suspension::node {

GapMonitor::GapMonitor(std::size_t capacity) : capacity_(std::max(capacity, kCapacity)) {
  if (capacity_ > kCapacity) {
    samples_.resize(capacity_);
  }
}

void GapMonitor::forget() {
  first_ = count_;
  counters_.unmatched += waiting_.size();
  waiting_.clear();
}

void GapMonitor::match(std::uint64_t number, double force) {
  MatchedSample& sample = at(number);
  if (!std::isnan(sample.measured)) {
    ++counters_.unmatched;  // a second force of one stamp
    return;
  }
  sample.measured = force;
  matched_end_ = std::max(matched_end_, number + 1);
  ++counters_.matched;
  if (!std::isnan(sample.beside)) {
    ++paired_.samples;
    paired_.published += (force - sample.simulated) * (force - sample.simulated);
    paired_.other += (force - sample.beside) * (force - sample.beside);
  }
}

// Measured forces that came before their sample. Those older than it will find none any more.
void GapMonitor::takeWaiting(std::uint64_t number) {
  const std::int64_t stamp = at(number).stamp;
  const auto is_past = [&](const Waiting& waiting) {
    if (waiting.stamp == stamp) {
      match(number, waiting.force);
    } else if (waiting.stamp < stamp) {
      ++counters_.unmatched;
    }
    return waiting.stamp <= stamp;
  };
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_past), waiting_.end());
}

void GapMonitor::addSimulated(std::int64_t stamp, double displacement, double force, double beside) {
  if (!wanted_.load(std::memory_order_relaxed)) {
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (count_ > first_ && stamp <= at(count_ - 1).stamp) {
    first_ = count_;  // what waits may belong to the new replay
  }
  const std::uint64_t number = count_++;
  at(number) = {stamp, displacement, force, std::numeric_limits<double>::quiet_NaN(), beside};
  if (!waiting_.empty()) {
    takeWaiting(number);
  }
}

// Number of the first sample that is not earlier, by bisection: stamps increase with the numbers.
std::uint64_t GapMonitor::firstFrom(std::int64_t stamp) const {
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
  return low;
}

bool GapMonitor::addMeasured(std::int64_t stamp, double force) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!wanted_) {
    samples_.resize(capacity_);
    waiting_.reserve(kWaiting);
    wanted_ = true;
  }
  if (!std::isfinite(force)) {
    ++counters_.not_finite;
    return false;
  }
  const std::uint64_t number = firstFrom(stamp);
  if (number < count_ && at(number).stamp == stamp) {
    match(number, force);
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
  std::vector<MatchedSample> samples;
  std::uint64_t next = 0;
  std::uint64_t expected = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!wanted_ || count_ == first_) {
      return samples;
    }
    next = firstFrom(at(count_ - 1).stamp - static_cast<std::int64_t>(std::llround(window * 1e9)));
    expected = count_ - next;
  }
  samples.reserve(expected);
  for (bool more = true; more;) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (next < oldest()) {
      next = oldest();
      samples.clear();  // overtaken, or a new replay
    }
    copyPiece(next, count_, samples);
    more = next < count_;
  }
  return samples;
}

void GapMonitor::copyPiece(std::uint64_t& next, std::uint64_t end, std::vector<MatchedSample>& samples) const {
  constexpr std::uint64_t kPiece = 512;
  for (end = std::min(next + kPiece, end); next < end; ++next) {
    const MatchedSample& sample = at(next);
    if (!std::isnan(sample.measured)) {
      samples.push_back(sample);
    }
  }
}

void GapMonitor::read(std::uint64_t& next, std::size_t most, std::vector<MatchedSample>& samples) const {
  const std::size_t before = samples.size();
  samples.reserve(before + most);
  for (bool more = true; more;) {
    const std::lock_guard<std::mutex> lock(mutex_);
    next = std::max(next, oldest());
    copyPiece(next, std::max(next, matched_end_), samples);
    more = next < matched_end_ && samples.size() < before + most;
  }
}

MatchCounters GapMonitor::counters() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return counters_;
}

PairedErrors GapMonitor::pairedErrors() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return paired_;
}

void GapMonitor::clearPairedErrors() {
  const std::lock_guard<std::mutex> lock(mutex_);
  paired_ = {};
}

}  // namespace rubber_suspension::node
